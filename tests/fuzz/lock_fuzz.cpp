// This gives any bytes to the reader of locks: the result is one diagnostic or one lock, which
// differs from itself in nothing, and reads as it was written.

#include <string>

#include "compiler/lock/differences.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/writer.h"
#include "tests/fuzz/require.h"

using namespace suture::compiler;
using suture::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  model::Diagnostics findings;
  const lock::Locks locks = lock::read({{"a.capnp", text}}, findings);
  require(locks.files.size() + findings.size() == 1);
  for (const auto& [path, lock] : locks.files) {
    require(lock::differences(lock, lock).empty());
    const std::string once = lock::write(lock);
    const lock::Locks again = lock::read({{"a.capnp", once}}, findings);
    require(findings.empty() && lock::write(again.files.at(path)) == once);
  }
  return 0;
}
