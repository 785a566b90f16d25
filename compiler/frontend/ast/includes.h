#pragma once
// This knows which header includes which, also if a guard skipped the second time, and by which
// path.

#include <clang/Basic/FileEntry.h>
#include <clang/Lex/Preprocessor.h>

#include <map>
#include <optional>
#include <set>
#include <string>

namespace suture::compiler::frontend {

class Includes {
 public:
  /// Collects from now on.
  void watch(clang::Preprocessor& preprocessor);

  /// Tells if `from` reaches `header` by way of a generated header, that of `header` itself or of
  /// one that includes it: only these declare what is generated.
  bool throughGenerated(clang::FileEntryRef from, clang::FileEntryRef header) const;

  /// Returns the path at which the generated header of `header` was included, or nothing if it was
  /// not. What is generated lies at one path alone, so this is certain.
  std::optional<std::string> generatedPathOf(clang::FileEntryRef header) const;

  /// Returns the path below a directory of the include path at which `header` itself was first
  /// found, or nothing if it was found beside its includers only.
  std::optional<std::string> pathOf(clang::FileEntryRef header) const;

 private:
  class Watcher;
  using Files = std::set<const clang::FileEntry*>;
  using Paths = std::map<const clang::FileEntry*, std::string>;

  static std::optional<std::string> find(const Paths& paths, clang::FileEntryRef header);
  void reach(const clang::FileEntry* from, Files& reached) const;

  std::map<const clang::FileEntry*, Files> included_;
  Files generated_;
  Paths paths_;           // by header
  Paths generatedPaths_;  // by header, as an include of its generated header says them
};

}  // namespace suture::compiler::frontend
