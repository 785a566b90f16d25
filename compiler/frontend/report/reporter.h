#pragma once
// This prints findings through clang's own engine: caret, underlined range, notes, error limit.

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/FileManager.h>

#include <set>
#include <string>

#include "compiler/frontend/report/fix_collector.h"
#include "compiler/frontend/report/source_table.h"
#include "compiler/model/diagnostic.h"

namespace suture::compiler::frontend {

class Reporter {
 public:
  /// Counts warnings of the slugs in `fatal`, or all if it holds "all", as errors.
  Reporter(clang::DiagnosticsEngine& engine, const clang::LangOptions& language,
           const SourceTable& table, const std::set<std::string>& fatal, FixCollector& fixes)
      : engine_(engine), language_(language), table_(table), fatal_(fatal), fixes_(fixes) {}

  /// Prints the findings. Returns false if an error was among them.
  bool report(const model::Diagnostics& findings);

 private:
  enum class Underline { Yes, No };

  void print(clang::DiagnosticsEngine::Level level, const model::Source& source,
             const std::string& text, Underline underline = Underline::Yes,
             const std::vector<model::Fix>& fixes = {});
  clang::SourceLocation locate(const model::Source& source);
  clang::FixItHint hintOf(const model::Fix& fix) const;
  bool areOnOneLine(clang::SourceLocation a, clang::SourceLocation b) const;
  bool isError(const model::Diagnostic& finding) const;

  clang::DiagnosticsEngine& engine_;
  const clang::LangOptions& language_;
  const SourceTable& table_;
  const std::set<std::string>& fatal_;
  FixCollector& fixes_;
};

}  // namespace suture::compiler::frontend
