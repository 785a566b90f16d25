#pragma once
// This takes annotated headers and returns a model. The rest of the compiler sees clang through
// this header only.

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "compiler/frontend/report/fixes.h"
#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::frontend {

struct Request {
  std::vector<std::string> headers;  ///< as the user wrote them: messages repeat this spelling
  std::string targetName;
  std::string baseDirectory;      ///< the headers' paths in the model are relative to it
  std::string resourceDirectory;  ///< clang's own headers: <dir>/include/stddef.h
  std::vector<std::string> clangArguments;
  std::set<std::string> fatalWarnings;  ///< slugs, or "all"
  /// Tells if a lock folder has the lock of a header with this path: it decides where the include
  /// path leaves several.
  std::function<bool(const std::string& path)> hasLock;
};

/// A Frontend is one run of clang over one translation unit that includes all headers of a target.
/// It stays open until destruction, so that later stages can report with the source at hand.
class Frontend {
 public:
  explicit Frontend(Request request);
  ~Frontend();
  Frontend(const Frontend&) = delete;
  Frontend& operator=(const Frontend&) = delete;

  /// Parses and maps. Returns false after any error; it has been printed and the model must not be
  /// used.
  bool run();

  const model::Model& model() const;

  /// Prints findings to standard error in clang's form. Returns false if an error was among them.
  bool report(const model::Diagnostics& findings);

  /// Returns the headers with all fix-its applied; what a system header would need is left alone.
  Fixes fixes();

  /// Returns the absolute paths of all files that were read, system headers too, without
  /// duplicates.
  std::vector<std::string> dependencies() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace suture::compiler::frontend
