#include "compiler/frontend/ast/includes.h"

#include <clang/Basic/SourceManager.h>
#include <clang/Lex/PPCallbacks.h>

#include <algorithm>

#include "compiler/frontend/ast/generated_headers.h"

namespace suture::compiler::frontend {

class Includes::Watcher : public clang::PPCallbacks {
 public:
  Watcher(Includes& includes, const clang::SourceManager& sources)
      : includes_(includes), sources_(sources) {}

  void InclusionDirective(clang::SourceLocation hash, const clang::Token&, llvm::StringRef name,
                          bool, clang::CharSourceRange, clang::OptionalFileEntryRef file,
                          llvm::StringRef, llvm::StringRef, const clang::Module*, bool,
                          clang::SrcMgr::CharacteristicKind) override {
    const auto includer = sources_.getFileEntryRefForID(sources_.getFileID(hash));
    if (!file || !includer) return;
    includes_.included_[*includer].insert(*file);
    if (name.ends_with(kGeneratedSuffix)) includes_.generated_.insert(*file);
  }

 private:
  Includes& includes_;
  const clang::SourceManager& sources_;
};

void Includes::watch(clang::Preprocessor& preprocessor) {
  preprocessor.addPPCallbacks(std::make_unique<Watcher>(*this, preprocessor.getSourceManager()));
}

bool Includes::throughGenerated(clang::FileEntryRef from, clang::FileEntryRef header) const {
  Files reached;
  reach(from, reached);
  Files behindGenerated;
  for (const clang::FileEntry* file : generated_) {
    if (reached.contains(file)) reach(file, behindGenerated);
  }
  return behindGenerated.contains(header);
}

void Includes::reach(const clang::FileEntry* from, Files& reached) const {
  if (!reached.insert(from).second) return;
  const auto found = included_.find(from);
  if (found == included_.end()) return;
  for (const clang::FileEntry* file : found->second) reach(file, reached);
}

}  // namespace suture::compiler::frontend
