#pragma once
// These are messages of any schema, with the values that converters get wrong.

#include "tests/fuzz/decoder.h"

#include <random>
#include <vector>

namespace suture::fuzz {

using Random = std::minstd_rand;

/// Returns one frame as it comes from a socket: the default value of that type, most of it changed.
std::vector<std::byte> randomFrame(const Decoder& decoder, Random& random);

}  // namespace suture::fuzz
