#pragma once
// Which header of the model a declaration belongs to.

#include <clang/AST/Decl.h>
#include <clang/Basic/FileManager.h>
#include <clang/Lex/HeaderSearch.h>

#include <map>
#include <string>
#include <vector>

#include "compiler/model/model.h"

namespace suture::compiler::frontend {

class HeaderTable {
 public:
  HeaderTable(const clang::SourceManager& sources, clang::HeaderSearch& search,
              std::string baseDirectory);

  /// A header of the target itself. False if there is no such file.
  bool addOwn(const std::string& header);

  /// The header that the declaration stands in, added as foreign when it is new.
  model::Header& of(const clang::Decl* declaration);

  /// All headers, sorted by path.
  std::vector<model::Header> take();

 private:
  std::string pathOf(clang::FileEntryRef file) const;

  const clang::SourceManager& sources_;
  clang::HeaderSearch& search_;
  std::string baseDirectory_;
  std::map<const clang::FileEntry*, model::Header> headers_;
};

}  // namespace suture::compiler::frontend
