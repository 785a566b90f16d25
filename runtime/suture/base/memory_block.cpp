#include <fcntl.h>
#include <suture/base/errors.h>
#include <suture/base/memory_block.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace suture {
namespace {

constexpr int kFixedSize = F_SEAL_SHRINK | F_SEAL_GROW;

[[noreturn]] void fail(const char* name, const char* step, std::size_t size) {
  throw SetupError("cannot make the memory block '" + std::string(name) + "' of " +
                       std::to_string(size) + " bytes",
                   std::string(step) + ": " + std::strerror(errno),
                   "Check the limits on memory and open files (ulimit -v, ulimit -n)");
}

[[noreturn]] void refuse(const std::string& found) {
  throw SetupError("use the memory block of another process", found,
                   "Build both processes from the same release");
}

}  // namespace

MemoryBlock::MemoryBlock(const char* name, std::size_t size, Others others)
    : MemoryBlock(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING), size) {
  if (descriptor_ < 0) fail(name, "memfd_create", size);
  if (ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail(name, "ftruncate", size);
  map(name, PROT_READ | PROT_WRITE);
  seal(name, others);
}

void MemoryBlock::seal(const char* name, Others others) {
  const int readOnly = others == Others::Read ? F_SEAL_FUTURE_WRITE : 0;
  if (fcntl(descriptor_, F_ADD_SEALS, kFixedSize | readOnly | F_SEAL_SEAL) != 0) {
    fail(name, "sealing", size_);
  }
}

std::shared_ptr<MemoryBlock> MemoryBlock::open(int descriptor, std::size_t size, Others others) {
  const int seals = fcntl(descriptor, F_GET_SEALS);
  if (seals < 0) refuse("it is no sealed memory");
  if ((seals & kFixedSize) != kFixedSize) refuse("it may shrink");
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || static_cast<std::size_t>(status.st_size) < size) {
    refuse("it has " + std::to_string(status.st_size) + " bytes of " + std::to_string(size));
  }
  const int own = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (own < 0) fail("of another process", "dup", size);
  std::shared_ptr<MemoryBlock> block(new MemoryBlock(own, size));
  block->map("of another process", others == Others::Read ? PROT_READ : PROT_READ | PROT_WRITE);
  return block;
}

// If this throws, the destructor undoes what has been done so far.
void MemoryBlock::map(const char* name, int protection) {
  void* const address = mmap(nullptr, size_, protection, MAP_SHARED | MAP_POPULATE, descriptor_, 0);
  if (address == MAP_FAILED) fail(name, "mmap", size_);
  data_ = static_cast<std::byte*>(address);
}

MemoryBlock::~MemoryBlock() {
  if (data_ != nullptr) munmap(data_, size_);
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace suture
