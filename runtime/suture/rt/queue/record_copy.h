#pragma once
// With these, consumers copy records out of memory that another process may change.

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace suture::rt {

/// Copies all of a record, for a consumer that knows nothing of it.
inline void copyAll(std::byte* to, const std::byte* from, std::size_t size) {
  std::memcpy(to, from, size);
}

/// Copies the head of a record of `size` bytes, and returns the copy. The original may change, so
/// the caller uses only the returned head to decide how much to copy of what lies behind it.
template <class Head>
Head copyHead(std::byte* to, const std::byte* from, std::size_t size) {
  Head head{};
  std::memcpy(&head, from, std::min(sizeof(head), size));
  std::memcpy(to, &head, std::min(sizeof(head), size));
  return head;
}

}  // namespace suture::rt
