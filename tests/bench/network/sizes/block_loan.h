#pragma once
// Both ends of `suture-bench network --part sizes` fill a block on loan by these.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bench/block_loop.suture.h"

namespace bench {

/// Names the list of a block in its slot.
template <class Contract>
inline constexpr auto kBytes = nullptr;
template <>
inline constexpr auto kBytes<SmallBlocks> = &SmallBlockSlot::bytes;
template <>
inline constexpr auto kBytes<LargeBlocks> = &LargeBlockSlot::bytes;

/// Returns what fills a list on loan with a copy of `bytes`.
inline auto copyOf(const std::vector<std::uint8_t>& bytes) {
  return [&bytes](std::span<std::uint8_t> room) {
    std::ranges::copy(bytes, room.begin());
    return bytes.size();
  };
}

}  // namespace bench
