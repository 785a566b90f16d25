#pragma once
// Prefaulted memory of a fixed size that another process can map later: a sealed memfd.

#include <cstddef>

namespace suture {

/// Owns the mapping and its descriptor. Zero-filled, page-aligned, cannot shrink or grow (a peer
/// that maps it can never be made to fault by a truncation). Not copyable; the address is stable.
class MemoryBlock {
 public:
  /// `name` shows in /proc/<pid>/maps. Throws SetupError if the kernel refuses.
  MemoryBlock(const char* name, std::size_t size);
  ~MemoryBlock();
  MemoryBlock(const MemoryBlock&) = delete;
  MemoryBlock& operator=(const MemoryBlock&) = delete;

  std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }
  int descriptor() const { return descriptor_; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_;
  int descriptor_;
};

}  // namespace suture
