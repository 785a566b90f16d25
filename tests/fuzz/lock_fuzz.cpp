// The reader of locks on any bytes: a diagnostic or a lock, and a lock reads back as it is written.

#include <cstdlib>
#include <string>

#include "compiler/lock/differences.h"
#include "compiler/lock/lock.h"
#include "compiler/lock/writer.h"

namespace {

using namespace suture::compiler;

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  model::Diagnostics findings;
  const lock::Locks locks = lock::read({{"a.capnp", text}}, findings);
  require(locks.files.size() + findings.size() == 1);
  for (const auto& [path, lock] : locks.files) {
    require(lock::differences(lock, lock).empty());
    const std::string written = lock::write(lock);
    const lock::Locks again = lock::read({{"a.capnp", written}}, findings);
    require(again.files.size() == 1 && lock::write(again.files.begin()->second) == written);
  }
  return 0;
}
