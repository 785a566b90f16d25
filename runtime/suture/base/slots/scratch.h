#pragma once
// This is memory for a value that is too large for a thread's stack.

#include <cstddef>

namespace suture {

/// Limits what a value may take up on a stack. A thread's stack may be as small as 64 KiB, and a
/// read of several values puts all of them there.
inline constexpr std::size_t kLargestOnStack = 4 * 1024;

/// Holds one block of memory. It comes from the blocks that the calling thread has used before and
/// goes back to them, so a thread allocates only when it needs more blocks, or a larger one, than
/// ever before. The thread that makes it must destroy it.
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

/// Gives the calling thread two blocks of `bytes` unless such a value fits on a stack: one for the
/// value that it handles, and one for a value that it reads or emits meanwhile.
void reserveScratch(std::size_t bytes);

}  // namespace suture
