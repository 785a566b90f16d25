#pragma once
// Memory for a value that is too large for a thread's stack.

#include <cstddef>

namespace suture {

/// What a value may take up on a stack; a thread's may be as small as 64 KiB.
inline constexpr std::size_t kLargestOnStack = 16 * 1024;

/// One block of memory. It comes from the blocks that the calling thread has used before and goes
/// back to them, so a thread allocates only when it needs one more, or a larger one, than ever
/// before. Is destroyed by the thread that made it.
class Scratch {
 public:
  /// Throws std::bad_alloc.
  explicit Scratch(std::size_t bytes);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::byte* memory() const { return memory_; }

 private:
  std::size_t bytes_;
  std::byte* memory_;
};

}  // namespace suture
