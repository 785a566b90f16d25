#include <suture/base/arena.h>
#include <suture/base/errors.h>
#include <sys/mman.h>

#include <cstring>
#include <new>
#include <string>

namespace suture {
namespace {

constexpr std::size_t kCacheLine = 64;

std::shared_ptr<std::byte> map(std::size_t size, int flags) {
  void* const memory =
      mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | flags, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<std::byte*>(memory), [size](std::byte* piece) { munmap(piece, size); }};
}

// Returns zeros and touches every page now, so that no control loop has a page fault. The kernel
// prepares many pages at once in two thirds of the time that single faults take.
std::shared_ptr<std::byte> allocate(std::size_t size) {
  constexpr std::size_t kManyPages = std::size_t{64} << 10;
  if (size >= kManyPages) return map(size, MAP_POPULATE);
  constexpr std::align_val_t kAlignment{kCacheLine};
  auto* const memory = static_cast<std::byte*>(::operator new(size, kAlignment));
  std::memset(memory, 0, size);
  return {memory, [](std::byte* piece) { ::operator delete(piece, kAlignment); }};
}

// Returns zeros that take no memory until a page is written.
std::shared_ptr<std::byte> reserve(std::size_t size) {
  return size == 0 ? nullptr : map(size, MAP_NORESERVE);
}

}  // namespace

Arena::Arena(std::shared_ptr<MemoryBlock> block, Content content)
    : isMaker_(content == Content::Zeros), block_(std::move(block)) {}

Arena Arena::measuring() {
  Arena arena;
  arena.isMaker_ = false;
  arena.measures_ = true;
  return arena;
}

std::shared_ptr<std::byte> Arena::take(std::size_t size) {
  const std::size_t rounded = (size + kCacheLine - 1) / kCacheLine * kCacheLine;
  const std::size_t begin = used_;
  used_ += rounded;
  if (measures_) return reserve(rounded);
  if (block_ == nullptr) return allocate(rounded);
  if (used_ > block_->size()) {
    throw SetupError("use a memory block of " + std::to_string(block_->size()) + " bytes",
                     "it is too small", "Build both processes from the same release");
  }
  return {block_, block_->data() + begin};
}

}  // namespace suture
