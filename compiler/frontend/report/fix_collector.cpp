#include "compiler/frontend/report/fix_collector.h"

#include <clang/Basic/SourceManager.h>
#include <clang/Edit/Commit.h>
#include <clang/Edit/EditsReceiver.h>
#include <clang/Rewrite/Core/Rewriter.h>
#include <llvm/Support/FileSystem.h>

#include <set>
#include <utility>

namespace suture::compiler::frontend {
namespace {

using Level = clang::DiagnosticsEngine::Level;

class Receiver : public clang::edit::EditsReceiver {
 public:
  explicit Receiver(clang::Rewriter& rewriter) : rewriter_(rewriter) {}

  void insert(clang::SourceLocation location, llvm::StringRef text) override {
    rewriter_.InsertText(location, text);
  }
  void replace(clang::CharSourceRange range, llvm::StringRef text) override {
    rewriter_.ReplaceText(range.getBegin(), rewriter_.getRangeSize(range), text);
  }

 private:
  clang::Rewriter& rewriter_;
};

bool isOurs(const clang::FixItHint& hint, const clang::SourceManager& sources) {
  const clang::SourceLocation place = hint.RemoveRange.getBegin();
  return place.isValid() && !sources.isInSystemHeader(place);
}

bool isInsertion(const clang::FixItHint& hint) {
  return hint.RemoveRange.isCharRange() && hint.RemoveRange.getBegin() == hint.RemoveRange.getEnd();
}

/// Remembers insertions, because several findings may ask for one and the same.
using Inserted = std::set<std::pair<clang::SourceLocation, std::string>>;

/// Applies the hints. Returns false, and changes no text, unless all of them can be applied.
bool commit(const std::vector<clang::FixItHint>& hints, clang::edit::EditedSource& edited,
            Inserted& inserted) {
  const clang::SourceManager& sources = edited.getSourceManager();
  clang::edit::Commit change(edited);
  Inserted added;
  for (const clang::FixItHint& hint : hints) {
    if (!isOurs(hint, sources)) return false;
    if (isInsertion(hint)) {
      const Inserted::value_type one{hint.RemoveRange.getBegin(), hint.CodeToInsert};
      if (inserted.contains(one) || !added.insert(one).second) continue;
    }
    if (hint.CodeToInsert.empty()) {
      change.remove(hint.RemoveRange);
    } else if (isInsertion(hint)) {
      change.insert(hint.RemoveRange.getBegin(), hint.CodeToInsert);
    } else {
      change.replace(hint.RemoveRange, hint.CodeToInsert);
    }
  }
  if (hints.empty() || !change.isCommitable() || !edited.commit(change)) return false;
  inserted.merge(added);
  return true;
}

}  // namespace

void FixCollector::BeginSourceFile(const clang::LangOptions& language,
                                   const clang::Preprocessor* preprocessor) {
  printer_->BeginSourceFile(language, preprocessor);
}

void FixCollector::EndSourceFile() { printer_->EndSourceFile(); }

void FixCollector::HandleDiagnostic(Level level, const clang::Diagnostic& finding) {
  DiagnosticConsumer::HandleDiagnostic(level, finding);
  printer_->HandleDiagnostic(level, finding);
  if (level < Level::Warning) return;
  Hints hints = std::exchange(unprinted_, {});
  hints.insert(hints.end(), finding.getFixItHints().begin(), finding.getFixItHints().end());
  if (level >= Level::Error || !hints.empty()) hints_.push_back(std::move(hints));
}

Fixes FixCollector::apply(clang::SourceManager& sources, const clang::LangOptions& language) const {
  Fixes result;
  clang::edit::EditedSource edited(sources, language);
  Inserted inserted;
  for (const Hints& hints : hints_)
    ++(commit(hints, edited, inserted) ? result.fixed : result.open);
  clang::Rewriter rewriter(sources, language);
  Receiver receiver(rewriter);
  edited.applyRewrites(receiver);
  for (auto file = rewriter.buffer_begin(); file != rewriter.buffer_end(); ++file) {
    const auto entry = sources.getFileEntryRefForID(file->first);
    llvm::SmallString<256> path;
    if (!entry || llvm::sys::fs::real_path(entry->getName(), path)) continue;
    result.files.push_back(
        {path.str().str(), std::string(file->second.begin(), file->second.end())});
  }
  return result;
}

}  // namespace suture::compiler::frontend
