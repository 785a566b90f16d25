#include <suture/base/arena.h>
#include <suture/base/errors.h>

#include <cstring>
#include <string>

namespace suture {
namespace {

constexpr std::size_t kCacheLine = 64;

std::shared_ptr<std::byte> allocate(std::size_t size) {
  constexpr std::align_val_t kAlignment{kCacheLine};
  auto* const memory = static_cast<std::byte*>(::operator new(size, kAlignment));
  std::memset(memory, 0, size);  // touches every page now, not in a control loop
  return {memory, [](std::byte* piece) { ::operator delete(piece, kAlignment); }};
}

}  // namespace

Arena::Arena(std::shared_ptr<MemoryBlock> block, Content content)
    : isMaker_(content == Content::Zeros), block_(std::move(block)) {}

std::shared_ptr<std::byte> Arena::take(std::size_t size) {
  const std::size_t rounded = (size + kCacheLine - 1) / kCacheLine * kCacheLine;
  const std::size_t begin = used_;
  used_ += rounded;
  if (block_ == nullptr) return allocate(rounded);
  if (used_ > block_->size()) {
    throw SetupError("use a memory block of " + std::to_string(block_->size()) + " bytes",
                     "it is too small", "Build both processes from the same release");
  }
  return {block_, block_->data() + begin};
}

}  // namespace suture
