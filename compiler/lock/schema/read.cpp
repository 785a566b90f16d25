#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/parse.h"
#include "compiler/lock/schema/tokens.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

model::Diagnostic unreadable(const model::Source& source, const SyntaxError& error,
                             const Options& options) {
  std::string slug = "lock-syntax", help = "restore the committed file; it is never edited by hand";
  if (error.kind == SyntaxError::Kind::Conflict) {
    slug = "lock-conflict";
    help = "take one side of it, run: " + options.command + ", and commit the file that it writes";
  } else if (error.kind == SyntaxError::Kind::Newer) {
    slug = "lock-newer";
    help = "use the suturec that wrote it, or restore the lock of before";
  }
  return {source, slug, std::string("this lock cannot be read: ") + error.what(), help, {}};
}

}  // namespace

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
      diagnostics.push_back(
          unreadable({0, options.folder + "/" + path, error.line}, error, options));
    }
  }
  return locks;
}

void readOthers(const std::vector<model::Artefact>& texts, Locks& locks) {
  for (const auto& [path, text] : texts) {
    try {
      locks.others.emplace(path, parse(path, text));
    } catch (const SyntaxError&) {
      continue;
    }
  }
}

}  // namespace suture::compiler::lock
