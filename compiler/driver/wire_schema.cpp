#include "compiler/driver/wire_schema.h"

#include <cinttypes>
#include <cstdio>

namespace suture::compiler::driver {
namespace {

// Returns the FNV-1a hash, with the top bit that capnp demands. Nothing refers to an empty file, so
// any distinct id will do.
std::uint64_t idOf(const std::string& path) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : path) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash | (std::uint64_t{1} << 63);
}

}  // namespace

model::Artefact wireSchema(const model::Header& header, const lock::Locks& locks) {
  const std::string path = lock::lockPath(header.path);
  if (const auto lock = locks.files.find(path); lock != locks.files.end()) {
    return {path, lock->second.text};
  }
  char id[32];
  std::snprintf(id, sizeof id, "@0x%" PRIx64 ";\n", idOf(path));
  return {path, "# " + header.path + " declares nothing that crosses a wire.\n" + id};
}

}  // namespace suture::compiler::driver
