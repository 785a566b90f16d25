#pragma once
// Preparation and recovery: what serialization, dynamic creation and deserialization of a value
// cost.

#include <cstddef>

#include "bench/figures/statistics.h"

namespace bench {

/// ns of processor time a value; each sample is the mean of one loop of kCodecLoop values.
struct CodecCost {
  Statistics encode;  ///< an object into the bytes of a Cap'n Proto message, through its slot
  Statistics create;  ///< a new object, and its end
  Statistics decode;  ///< those bytes into an object
  Statistics sum;     ///< object, bytes, new object: all three in one loop
  std::size_t bytes = 0;
};

constexpr std::size_t kCodecLoop = 10000;

/// Measures `loops` loops of each. Throws std::logic_error if what comes out is not what went in.
CodecCost measureCodec(std::size_t loops);

}  // namespace bench
