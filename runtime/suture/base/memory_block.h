#pragma once
// Prefaulted memory of a fixed size that another process can map: a sealed memfd.

#include <cstddef>
#include <cstdint>
#include <memory>

namespace suture {

/// Owns the mapping and its descriptor. Zero-filled, page-aligned, cannot shrink or
/// grow (a peer that maps it can never be made to fault by a truncation). Not copyable; the address
/// is stable.
class MemoryBlock {
 public:
  /// A process that is handed the descriptor may do this.
  enum class Others : std::uint8_t { Write, Read };

  /// `name` shows in /proc/<pid>/maps. Throws SetupError if the kernel refuses.
  MemoryBlock(const char* name, std::size_t size, Others others = Others::Write);
  ~MemoryBlock();
  MemoryBlock(const MemoryBlock&) = delete;
  MemoryBlock& operator=(const MemoryBlock&) = delete;

  /// Maps another process's block, of which `descriptor` (kept by the caller) is a handle; `others`
  /// is what that process has granted. Throws SetupError if it is no memfd, not sealed against
  /// shrinking, or of fewer than `size` bytes.
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
