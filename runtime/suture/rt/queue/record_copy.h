#pragma once
// Consumers copy records out of memory that another process may change.

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace suture::rt {

/// A consumer that knows nothing of a record copies all of it.
inline void copyAll(std::byte* to, const std::byte* from, std::size_t size) {
  std::memcpy(to, from, size);
}

/// Copies the head of a record of `size` bytes, and returns it as it was copied: what lies behind
/// it is copied by what this says, since the original may change.
template <class Head>
Head copyHead(std::byte* to, const std::byte* from, std::size_t size) {
  Head head{};
  std::memcpy(&head, from, std::min(sizeof(head), size));
  std::memcpy(to, &head, std::min(sizeof(head), size));
  return head;
}

}  // namespace suture::rt
