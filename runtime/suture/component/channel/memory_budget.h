#pragma once

#include <cstddef>

namespace suture {

/// Any thread. How many of something a connection keeps: `most`, or half of that and so on until
/// they take up no more than 4 MiB by `bytesFor(count)`, but at least `fewest`. Whoever makes that
/// memory touches all of it, and may be the thread that answers heartbeats.
template <class BytesFor>
unsigned fewerOfLarge(unsigned most, unsigned fewest, const BytesFor& bytesFor) {
  constexpr std::size_t kMostBytes = std::size_t{4} << 20;
  unsigned count = most;
  while (count > fewest && bytesFor(count) > kMostBytes) count /= 2;
  return count;
}

}  // namespace suture
