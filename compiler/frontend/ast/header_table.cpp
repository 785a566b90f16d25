#include "compiler/frontend/ast/header_table.h"

#include <clang/Basic/SourceManager.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace suture::compiler::frontend {
namespace {

std::optional<std::string> below(const std::string& directory, llvm::StringRef file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path relative = fs::weakly_canonical(file.str(), ignored)
                                .lexically_relative(fs::weakly_canonical(directory, ignored));
  if (relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative.generic_string();
}

}  // namespace

HeaderTable::HeaderTable(const clang::SourceManager& sources, clang::HeaderSearch& search,
                         const Includes& includes, std::string baseDirectory, HasLock hasLock)
    : sources_(sources),
      search_(search),
      includes_(includes),
      baseDirectory_(std::move(baseDirectory)),
      hasLock_(std::move(hasLock)) {}

bool HeaderTable::addOwn(const std::string& header) {
  const auto file = sources_.getFileManager().getOptionalFileRef(header);
  if (!file) return false;
  model::Header& entry = headers_[&file->getFileEntry()];
  entry.path = pathOf(*file);
  entry.file = file->getName().str();
  entry.own = true;
  return true;
}

model::Header& HeaderTable::of(const clang::Decl* declaration) {
  const clang::OptionalFileEntryRef file = fileOf(declaration);
  const auto [entry, added] =
      headers_.try_emplace(file ? &file->getFileEntry() : nullptr, model::Header{});
  if (added) {
    entry->second.own = false;
    if (file) {
      entry->second.path = foreignPathOf(*file);
      entry->second.file = file->getName().str();
    }
  }
  return entry->second;
}

bool HeaderTable::isOwn(const clang::Decl* declaration) const {
  const clang::OptionalFileEntryRef file = fileOf(declaration);
  const auto entry = headers_.find(file ? &file->getFileEntry() : nullptr);
  return entry != headers_.end() && entry->second.own;
}

clang::OptionalFileEntryRef HeaderTable::fileOf(const clang::Decl* declaration) const {
  return sources_.getFileEntryRefForID(
      sources_.getFileID(sources_.getExpansionLoc(declaration->getLocation())));
}

// Where all targets of a tree share the base directory, this is true of a foreign header as well.
std::string HeaderTable::pathOf(clang::FileEntryRef file) const {
  if (auto relative = below(baseDirectory_, file.getName())) return *relative;
  return search_.suggestPathToFileForDiagnostics(file, "");
}

// A target whose include root is another one than that of a header cannot tell its path from where
// the file lies: "x.h" may have been found beside its includer. Whatever the root, the lock has its
// path below it.
std::string HeaderTable::foreignPathOf(clang::FileEntryRef file) const {
  if (const auto generated = includes_.generatedPathOf(file)) return *generated;
  const std::vector<std::string> paths = possiblePathsOf(file);
  const auto locked = std::find_if(paths.begin(), paths.end(), hasLock_);
  return locked != paths.end() ? *locked : paths.front();
}

/// Returns the likely ones first.
std::vector<std::string> HeaderTable::possiblePathsOf(clang::FileEntryRef file) const {
  std::vector<std::string> paths;
  if (const auto included = includes_.pathOf(file)) paths.push_back(*included);
  paths.push_back(pathOf(file));
  for (const clang::DirectoryLookup& directory : search_.search_dir_range()) {
    if (auto path = below(directory.getName().str(), file.getName())) paths.push_back(*path);
  }
  return paths;
}

std::vector<model::Header> HeaderTable::take() {
  std::vector<model::Header> headers;
  for (auto& [file, header] : headers_) headers.push_back(std::move(header));
  std::sort(headers.begin(), headers.end(),
            [](const auto& a, const auto& b) { return a.path < b.path; });
  return headers;
}

}  // namespace suture::compiler::frontend
