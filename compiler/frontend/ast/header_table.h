#pragma once
// This knows which header of the model a declaration belongs to.

#include <clang/AST/Decl.h>
#include <clang/Basic/FileManager.h>
#include <clang/Lex/HeaderSearch.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compiler/frontend/ast/includes.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

/// Tells if a lock folder has the lock of a header with this path.
using HasLock = std::function<bool(const std::string& path)>;

class HeaderTable {
 public:
  HeaderTable(const clang::SourceManager& sources, clang::HeaderSearch& search,
              const Includes& includes, std::string baseDirectory, HasLock hasLock);

  /// Adds a header of the target itself. Returns false if there is no such file.
  bool addOwn(const std::string& header);

  /// Returns the header that the declaration stands in, and adds it as foreign if it is new.
  model::Header& of(const clang::Decl* declaration);

  /// Tells if the declaration stands in a header of the target itself.
  bool isOwn(const clang::Decl* declaration) const;

  /// Hands over all headers, sorted by path.
  std::vector<model::Header> take();

 private:
  clang::OptionalFileEntryRef fileOf(const clang::Decl* declaration) const;
  std::string pathOf(clang::FileEntryRef file) const;
  std::string foreignPathOf(clang::FileEntryRef file) const;
  std::vector<std::string> possiblePathsOf(clang::FileEntryRef file) const;

  const clang::SourceManager& sources_;
  clang::HeaderSearch& search_;
  const Includes& includes_;
  std::string baseDirectory_;
  HasLock hasLock_;
  std::map<const clang::FileEntry*, model::Header> headers_;
};

}  // namespace suture::compiler::frontend
