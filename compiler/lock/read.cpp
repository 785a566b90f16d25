#include "compiler/lock/lock.h"
#include "compiler/lock/parse.h"
#include "compiler/lock/tokens.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {

std::string lockPath(std::string_view headerPath) { return model::stemOf(headerPath) + ".capnp"; }

bool needsLock(const model::Header& header) {
  return !header.enums.empty() || !header.structs.empty() || !header.interfaces.empty();
}

Locks read(const std::vector<model::Artefact>& texts, model::Diagnostics& diagnostics,
           const Options& options) {
  Locks locks;
  for (const auto& [path, text] : texts) {
    try {
      locks.files.emplace(path, parse(path, text));
    } catch (const SyntaxError& error) {
      diagnostics.push_back({{0, options.folder + "/" + path, error.line},
                             "lock-syntax",
                             std::string("this lock cannot be read: ") + error.what(),
                             "restore the committed file; it is never edited by hand",
                             {}});
    }
  }
  return locks;
}

}  // namespace suture::compiler::lock
