#pragma once
// This knows which header includes which, also if a guard skipped the second time.

#include <clang/Basic/FileEntry.h>
#include <clang/Lex/Preprocessor.h>

#include <map>
#include <set>

namespace suture::compiler::frontend {

class Includes {
 public:
  /// Collects from now on.
  void watch(clang::Preprocessor& preprocessor);

  /// Tells if `from` reaches `header` by way of a generated header, that of `header` itself or of
  /// one that includes it: only these declare what is generated.
  bool throughGenerated(clang::FileEntryRef from, clang::FileEntryRef header) const;

 private:
  class Watcher;
  using Files = std::set<const clang::FileEntry*>;

  void reach(const clang::FileEntry* from, Files& reached) const;

  std::map<const clang::FileEntry*, Files> included_;
  Files generated_;
};

}  // namespace suture::compiler::frontend
