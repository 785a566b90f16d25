#pragma once
// With this a fuzzer says that something does not hold.

#include <cstdlib>

namespace suture::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace suture::fuzz
