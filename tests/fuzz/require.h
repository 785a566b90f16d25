#pragma once
// A fuzzer ends by this when a condition does not hold, which libFuzzer reports with its input.

#include <cstdlib>

namespace suture::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace suture::fuzz
