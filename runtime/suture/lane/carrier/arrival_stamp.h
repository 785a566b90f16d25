#pragma once
// This says when a value that comes from a peer was made.

#include <suture/codec/stamps.h>
#include <suture/component/channel/channel.h>

#include <algorithm>
#include <cstdint>

namespace suture {

/// Any thread. Shifts a stamp of the peer to this process's clock, but not later than now: a stamp
/// in the future would have a negative age, and such a command would never be late. Returns now for
/// 0, which means that the peer does not say.
inline Time arrivalStamp(const Channel& channel, std::int64_t stamp) {
  const Time received = now();
  if (stamp == 0) return received;
  return std::clamp(fromNanoseconds(codec::shifted(stamp, channel.clockShift())), Time{}, received);
}

}  // namespace suture
