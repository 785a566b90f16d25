#pragma once
// This is prefaulted memory of a fixed size that another process can map: a sealed memfd.

#include <cstddef>
#include <cstdint>
#include <memory>

namespace suture {

/// Owns the mapping and its descriptor. The memory is zero-filled and page-aligned, and its address
/// is stable. Its size cannot change, so that no peer that maps it can be made to fault by a
/// truncation.
class MemoryBlock {
 public:
  /// Says what a process that receives the descriptor may do.
  enum class Others : std::uint8_t { Write, Read };

  /// `name` shows in `/proc/PID/maps`. Throws SetupError if the kernel refuses.
  MemoryBlock(const char* name, std::size_t size, Others others = Others::Write);
  ~MemoryBlock();
  MemoryBlock(const MemoryBlock&) = delete;
  MemoryBlock& operator=(const MemoryBlock&) = delete;

  /// Maps another process's block. `descriptor`, which stays the caller's, refers to it; `others`
  /// is what that process has granted. Throws SetupError if it is no memfd, not sealed against
  /// shrinking, or smaller than `size` bytes.
  static std::shared_ptr<MemoryBlock> open(int descriptor, std::size_t size, Others others);

  std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }
  int descriptor() const { return descriptor_; }

 private:
  MemoryBlock(int descriptor, std::size_t size) : size_(size), descriptor_(descriptor) {}
  void seal(const char* name, Others others);
  void map(const char* name, int protection);

  std::byte* data_ = nullptr;
  std::size_t size_;
  int descriptor_;
};

}  // namespace suture
