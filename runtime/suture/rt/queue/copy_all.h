#pragma once
// How a consumer copies a record out of foreign memory if it knows nothing of it.

#include <cstddef>
#include <cstring>

namespace suture::rt {

inline void copyAll(std::byte* to, const std::byte* from, std::size_t size) {
  std::memcpy(to, from, size);
}

}  // namespace suture::rt
