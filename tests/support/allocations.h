#pragma once
// Counts what the calling thread takes from the heap: this program brings a malloc of its own in
// front of the C library's.

#include <cstdint>

namespace suture {

/// Returns how often the calling thread has allocated. It is always 0 where countsAllocations() is
/// false.
std::uint64_t allocations();

/// Returns false under a sanitizer, which needs malloc for itself.
bool countsAllocations();

/// Any thread may make this; a process may have one at a time. Counts, while it lives, what all
/// threads of one name allocate.
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
