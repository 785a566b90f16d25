#pragma once
// Nothing annotated is skipped silently: every use of the vocabulary is found again in the tree.

#include <clang/AST/Decl.h>
#include <clang/Lex/Preprocessor.h>

#include <map>
#include <string>

namespace suture::compiler::frontend {

/// Where macros of the vocabulary were expanded, less those that a visited declaration bears.
class AnnotationUses {
 public:
  /// Collects from now on.
  void watch(clang::Preprocessor& preprocessor);

  /// The declaration's annotations were seen.
  void claim(const clang::Decl* declaration);

  /// The macro's name by the place of its use, of those that no declaration claimed.
  const std::map<clang::SourceLocation, std::string>& unclaimed() const { return open_; }

 private:
  class Watcher;

  const clang::SourceManager* sources_ = nullptr;
  std::map<clang::SourceLocation, std::string> open_;
};

}  // namespace suture::compiler::frontend
