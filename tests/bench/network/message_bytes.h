#pragma once
// What a bare socket carries in the place of a lane's message.

#include <cstddef>

namespace bench {

/// PoseSample as a message: 15 words and a header.
constexpr std::size_t kMessageBytes = 144;

}  // namespace bench
