#pragma once
// This finds every use of the vocabulary again in the tree, so that nothing annotated is skipped
// silently.

#include <clang/AST/Decl.h>
#include <clang/Lex/Preprocessor.h>

#include <map>
#include <string>

namespace suture::compiler::frontend {

/// Holds where macros of the vocabulary were expanded, less those that a visited declaration bears.
class AnnotationUses {
 public:
  /// Collects from now on.
  void watch(clang::Preprocessor& preprocessor);

  /// Takes off the list what the declaration bears, because it was visited.
  void claim(const clang::Decl* declaration);

  /// Takes off the list what stands in front of an anonymous struct or union: clang drops it.
  void claimBefore(const clang::RecordDecl* anonymous);

  /// Returns the macros that no declaration claimed: their names, by the place of their use.
  const std::map<clang::SourceLocation, std::string>& unclaimed() const { return open_; }

 private:
  class Watcher;

  const clang::SourceManager* sources_ = nullptr;
  std::map<clang::SourceLocation, std::string> open_;
};

}  // namespace suture::compiler::frontend
