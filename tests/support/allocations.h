#pragma once
// Counts what the calling thread takes from the heap: this program brings a malloc of its own in
// front of the C library's.

#include <cstdint>

namespace suture {

/// How often the calling thread has allocated. Always 0 where countsAllocations() is false.
std::uint64_t allocations();

/// False under a sanitizer, which needs malloc for itself.
bool countsAllocations();

/// Counts, while it lives, what all threads of one name allocate. One at a time in a process; any
/// thread.
class NamedThreadAllocations {
 public:
  /// `name`: at most 15 characters, kept by reference.
  explicit NamedThreadAllocations(const char* name);
  ~NamedThreadAllocations();
  NamedThreadAllocations(const NamedThreadAllocations&) = delete;
  NamedThreadAllocations& operator=(const NamedThreadAllocations&) = delete;

  std::uint64_t count() const;
};

}  // namespace suture
