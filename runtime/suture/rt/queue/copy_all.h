#pragma once
// A consumer that knows nothing of a record copies it so out of foreign memory.

#include <cstddef>
#include <cstring>

namespace suture::rt {

inline void copyAll(std::byte* to, const std::byte* from, std::size_t size) {
  std::memcpy(to, from, size);
}

}  // namespace suture::rt
