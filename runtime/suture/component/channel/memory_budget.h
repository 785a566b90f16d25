#pragma once

#include <cstddef>

namespace suture {

/// Any thread. Returns how many of something a connection keeps: `most`, or half of that and so on
/// until they take up no more than 4 MiB by `bytesFor(count)`, but at least `fewest`. The thread
/// that allocates touches all of that memory, and may be the one that answers heartbeats.
template <class BytesFor>
unsigned fewerOfLarge(unsigned most, unsigned fewest, const BytesFor& bytesFor) {
  constexpr std::size_t kMostBytes = std::size_t{4} << 20;
  unsigned count = most;
  while (count > fewest && bytesFor(count) > kMostBytes) count /= 2;
  return count;
}

}  // namespace suture
