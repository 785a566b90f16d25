#include "compiler/frontend/reporter.h"

#include <clang/Basic/SourceManager.h>

#include <string>

namespace suture::compiler::frontend {

using Level = clang::DiagnosticsEngine::Level;

bool Reporter::report(const model::Diagnostics& findings) {
  bool clean = true;
  for (const model::Diagnostic& finding : findings) {
    const bool error = finding.severity == model::Diagnostic::Severity::Error;
    clean = clean && !error;
    print(error ? Level::Error : Level::Warning, finding.source,
          finding.message + " [suture-" + finding.slug + "]");
    if (!finding.help.empty()) print(Level::Note, finding.source, finding.help, Underline::No);
    for (const model::Note& note : finding.notes) print(Level::Note, note.source, note.text);
  }
  return clean;
}

// Without an underline, clang does not repeat the source line after an error in the same place.
void Reporter::print(Level level, const model::Source& source, const std::string& text,
                     Underline underline) {
  const unsigned id = engine_.getDiagnosticIDs()->getCustomDiagID(
      static_cast<clang::DiagnosticIDs::Level>(level), "%0");
  if (const SourceTable::Place* place = table_.find(source)) {
    auto builder = engine_.Report(place->caret, id);
    builder << text;
    if (place->range.isValid() && underline == Underline::Yes) builder << place->range;
    return;
  }
  const clang::SourceLocation location = locate(source);
  if (location.isValid() || source.file.empty()) {
    engine_.Report(location, id) << text;
  } else {
    const std::string line = source.line > 0 ? ":" + std::to_string(source.line) : "";
    engine_.Report(id) << source.file + line + ": " + text;
  }
}

// A place outside the translation unit, such as a line of a lock file.
clang::SourceLocation Reporter::locate(const model::Source& source) {
  if (source.file.empty() || source.line == 0) return {};
  clang::SourceManager& sources = engine_.getSourceManager();
  const auto file = sources.getFileManager().getOptionalFileRef(source.file);
  if (!file) return {};
  const clang::FileID id = sources.getOrCreateFileID(*file, clang::SrcMgr::C_User);
  return sources.translateLineCol(id, source.line, 1);
}

}  // namespace suture::compiler::frontend
