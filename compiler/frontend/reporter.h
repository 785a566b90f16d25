#pragma once
// Prints findings through clang's own engine: caret, underlined range, notes, error limit.

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/FileManager.h>

#include "compiler/frontend/source_table.h"
#include "compiler/model/diagnostic.h"

namespace suture::compiler::frontend {

class Reporter {
 public:
  Reporter(clang::DiagnosticsEngine& engine, const SourceTable& table)
      : engine_(engine), table_(table) {}

  /// False if an error was among them.
  bool report(const model::Diagnostics& findings);

 private:
  enum class Underline { Yes, No };

  void print(clang::DiagnosticsEngine::Level level, const model::Source& source,
             const std::string& text, Underline underline = Underline::Yes);
  clang::SourceLocation locate(const model::Source& source);

  clang::DiagnosticsEngine& engine_;
  const SourceTable& table_;
};

}  // namespace suture::compiler::frontend
