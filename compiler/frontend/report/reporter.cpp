#include "compiler/frontend/report/reporter.h"

#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

namespace suture::compiler::frontend {

using Level = clang::DiagnosticsEngine::Level;

bool Reporter::report(const model::Diagnostics& findings) {
  bool clean = true;
  for (const model::Diagnostic& finding : findings) {
    const bool error = isError(finding);
    clean = clean && !error;
    print(error ? Level::Error : Level::Warning, finding.source,
          finding.message + " [suture-" + finding.slug + "]", Underline::Yes, finding.fixes);
    if (!finding.help.empty()) print(Level::Note, finding.source, finding.help, Underline::No);
    for (const model::Note& note : finding.notes) {
      print(Level::Note, note.source, note.text, Underline::Yes, finding.fixes);
    }
  }
  return clean;
}

// Without an underline, clang does not repeat the source line after an error in the same place.
void Reporter::print(Level level, const model::Source& source, const std::string& text,
                     Underline underline, const std::vector<model::Fix>& fixes) {
  const unsigned id = engine_.getDiagnosticIDs()->getCustomDiagID(
      static_cast<clang::DiagnosticIDs::Level>(level), "%0");
  if (const SourceTable::Place* place = table_.find(source)) {
    std::vector<clang::FixItHint> shown;
    for (const model::Fix& fix : fixes) {
      const clang::FixItHint hint = hintOf(fix);
      if (hint.isNull()) continue;
      const bool near = areOnOneLine(hint.RemoveRange.getBegin(), place->caret);
      if (near) shown.push_back(hint);
      if (!near && level != Level::Note) fixes_.addToNext(hint);
    }
    auto builder = engine_.Report(place->caret, id);
    builder << text;
    if (place->range.isValid() && underline == Underline::Yes) builder << place->range;
    for (const clang::FixItHint& hint : shown) builder << hint;
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

bool Reporter::isError(const model::Diagnostic& finding) const {
  return finding.severity == model::Diagnostic::Severity::Error || fatal_.contains("all") ||
         fatal_.contains(finding.slug);
}

// Tells if a hint is on the finding's line. One that is elsewhere must not be shown with the
// finding, because clang would print all lines from the one to the other.
bool Reporter::areOnOneLine(clang::SourceLocation a, clang::SourceLocation b) const {
  const clang::SourceManager& sources = engine_.getSourceManager();
  return sources.getFileID(a) == sources.getFileID(sources.getExpansionLoc(b)) &&
         sources.getExpansionLineNumber(a) == sources.getExpansionLineNumber(b);
}

// Returns no hint for what a macro wrote, because the text to change is not where it seems.
clang::FixItHint Reporter::hintOf(const model::Fix& fix) const {
  const SourceTable::Place* place = table_.find(fix.source);
  if (!place) return {};
  const clang::SourceRange range =
      place->range.isValid() ? place->range : clang::SourceRange(place->caret);
  if (range.getBegin().isMacroID() || range.getEnd().isMacroID()) return {};
  switch (fix.place) {
    case model::Fix::Place::Before:
      return clang::FixItHint::CreateInsertion(range.getBegin(), fix.text);
    case model::Fix::Place::After:
      return clang::FixItHint::CreateInsertion(
          clang::Lexer::getLocForEndOfToken(range.getEnd(), 0, engine_.getSourceManager(),
                                            language_),
          fix.text);
    case model::Fix::Place::Instead: return clang::FixItHint::CreateReplacement(range, fix.text);
  }
  return {};
}

// Finds a place outside the translation unit, such as a line of a lock file.
clang::SourceLocation Reporter::locate(const model::Source& source) {
  if (source.file.empty() || source.line == 0) return {};
  clang::SourceManager& sources = engine_.getSourceManager();
  const auto file = sources.getFileManager().getOptionalFileRef(source.file);
  if (!file) return {};
  const clang::FileID id = sources.getOrCreateFileID(*file, clang::SrcMgr::C_User);
  return sources.translateLineCol(id, source.line, 1);
}

}  // namespace suture::compiler::frontend
