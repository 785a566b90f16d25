#include "compiler/frontend/ast/includes.h"

#include <clang/Basic/FileManager.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/HeaderSearch.h>
#include <clang/Lex/PPCallbacks.h>
#include <llvm/ADT/SmallString.h>
#include <llvm/Support/Path.h>

#include <algorithm>

#include "compiler/frontend/ast/generated_headers.h"

namespace suture::compiler::frontend {

class Includes::Watcher : public clang::PPCallbacks {
 public:
  Watcher(Includes& includes, clang::Preprocessor& preprocessor)
      : includes_(includes),
        sources_(preprocessor.getSourceManager()),
        search_(preprocessor.getHeaderSearchInfo()) {}

  void InclusionDirective(clang::SourceLocation hash, const clang::Token&, llvm::StringRef name,
                          bool, clang::CharSourceRange, clang::OptionalFileEntryRef file,
                          llvm::StringRef directory, llvm::StringRef path, const clang::Module*,
                          bool, clang::SrcMgr::CharacteristicKind) override {
    const auto includer = sources_.getFileEntryRefForID(sources_.getFileID(hash));
    if (!file || !includer) return;
    includes_.included_[*includer].insert(*file);
    const bool isGenerated = name.ends_with(kGeneratedSuffix);
    if (isGenerated) includes_.generated_.insert(*file);
    if (isOnIncludePath(directory)) notePath(*file, path, isGenerated);
  }

 private:
  bool isOnIncludePath(llvm::StringRef directory) const {
    const auto directories = search_.search_dir_range();
    return std::any_of(
        directories.begin(), directories.end(),
        [=](const clang::DirectoryLookup& one) { return one.getName() == directory; });
  }

  void notePath(clang::FileEntryRef file, llvm::StringRef path, bool isGenerated) {
    llvm::SmallString<128> plain = path;
    llvm::sys::path::remove_dots(plain, /*remove_dot_dot=*/true);
    if (!isGenerated) {
      includes_.paths_.try_emplace(&file.getFileEntry(), plain.str());
      return;
    }
    const std::string source = sourceHeaderOf(file.getName());
    const auto header = sources_.getFileManager().getOptionalFileRef(source);
    if (!header) return;
    includes_.generatedPaths_.try_emplace(&header->getFileEntry(), sourceHeaderOf(plain));
  }

  Includes& includes_;
  const clang::SourceManager& sources_;
  const clang::HeaderSearch& search_;
};

void Includes::watch(clang::Preprocessor& preprocessor) {
  preprocessor.addPPCallbacks(std::make_unique<Watcher>(*this, preprocessor));
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

std::optional<std::string> Includes::generatedPathOf(clang::FileEntryRef header) const {
  return find(generatedPaths_, header);
}

std::optional<std::string> Includes::pathOf(clang::FileEntryRef header) const {
  return find(paths_, header);
}

std::optional<std::string> Includes::find(const Paths& paths, clang::FileEntryRef header) {
  const auto found = paths.find(&header.getFileEntry());
  if (found == paths.end()) return std::nullopt;
  return found->second;
}

void Includes::reach(const clang::FileEntry* from, Files& reached) const {
  if (!reached.insert(from).second) return;
  const auto found = included_.find(from);
  if (found == included_.end()) return;
  for (const clang::FileEntry* file : found->second) reach(file, reached);
}

}  // namespace suture::compiler::frontend
