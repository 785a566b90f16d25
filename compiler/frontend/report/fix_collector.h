#pragma once
// This keeps the fix-its of what is reported, so that `suturec --fix` can apply them.

#include <clang/Basic/Diagnostic.h>
#include <clang/Edit/EditedSource.h>

#include <memory>
#include <vector>

#include "compiler/frontend/report/fixes.h"

namespace suture::compiler::frontend {

/// Stands between clang's engine and the printer. As clang's own -fixit does, it takes the fix-its
/// of errors and warnings; those of notes are alternatives, which a person has to choose from.
class FixCollector : public clang::DiagnosticConsumer {
 public:
  void forwardTo(std::unique_ptr<clang::DiagnosticConsumer> printer) {
    printer_ = std::move(printer);
  }

  void BeginSourceFile(const clang::LangOptions& language,
                       const clang::Preprocessor* preprocessor) override;
  void EndSourceFile() override;
  void HandleDiagnostic(clang::DiagnosticsEngine::Level level,
                        const clang::Diagnostic& finding) override;

  /// Adds a hint to the next finding; clang itself shall not print it.
  void addToNext(clang::FixItHint hint) { unprinted_.push_back(std::move(hint)); }

  Fixes apply(clang::SourceManager& sources, const clang::LangOptions& language) const;

 private:
  using Hints = std::vector<clang::FixItHint>;

  std::unique_ptr<clang::DiagnosticConsumer> printer_;
  Hints unprinted_;
  std::vector<Hints> hints_;  // those of one finding each; an error without any has an empty entry
};

}  // namespace suture::compiler::frontend
