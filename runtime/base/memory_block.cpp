#include <fcntl.h>
#include <suture/base/errors.h>
#include <suture/base/memory_block.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace suture {
namespace {

[[noreturn]] void fail(const char* name, const char* step, std::size_t size) {
  throw SetupError("cannot make the memory block '" + std::string(name) + "' of " +
                       std::to_string(size) + " bytes",
                   std::string(step) + ": " + std::strerror(errno),
                   "Check the limits on memory and open files (ulimit -v, ulimit -n)");
}

}  // namespace

MemoryBlock::MemoryBlock(const char* name, std::size_t size)
    : size_(size), descriptor_(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (descriptor_ < 0) fail(name, "memfd_create", size);
  const bool sealed =
      ftruncate(descriptor_, static_cast<off_t>(size)) == 0 &&
      fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0;
  void* address = sealed ? mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE,
                                descriptor_, 0)
                         : MAP_FAILED;
  if (address == MAP_FAILED) {
    const int reason = errno;
    close(descriptor_);
    errno = reason;
    fail(name, sealed ? "mmap" : "sealing", size);
  }
  data_ = static_cast<std::byte*>(address);
}

MemoryBlock::~MemoryBlock() {
  munmap(data_, size_);
  close(descriptor_);
}

}  // namespace suture
