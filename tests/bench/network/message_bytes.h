#pragma once
// A bare socket carries as many bytes as a lane's message has, so that the rows can be compared.

#include <cstddef>

namespace bench {

/// A PoseSample as a message has this size: 15 words and a header.
constexpr std::size_t kMessageBytes = 144;

}  // namespace bench
