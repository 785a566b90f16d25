#pragma once
// Memory for a value that is too large for a thread's stack.

#include <cstddef>

namespace suture {

/// What a value may take up on a stack. A thread's stack may be as small as 64 KiB, and a read of
/// several values has them all there.
inline constexpr std::size_t kLargestOnStack = 4 * 1024;

/// One block of memory. It comes from the blocks that the calling thread has used before and goes
/// back to them, so a thread allocates only when it needs one more, or a larger one, than ever
/// before. Is destroyed by the thread that made it.
class ScratchMemory {
 public:
  /// Throws std::bad_alloc.
  explicit ScratchMemory(std::size_t bytes);
  ~ScratchMemory();
  ScratchMemory(const ScratchMemory&) = delete;
  ScratchMemory& operator=(const ScratchMemory&) = delete;

  std::byte* memory() const { return memory_; }

 private:
  std::size_t bytes_;
  std::byte* memory_;
};

/// Gives the calling thread memory for two values of `bytes` at a time, unless a stack has room for
/// them: one that it handles, and one that it reads or emits meanwhile.
void reserveScratch(std::size_t bytes);

}  // namespace suture
