#pragma once
// When a value that comes from a peer was made.

#include <suture/component/channel/channel.h>
#include <suture/wire/stamps.h>

#include <algorithm>
#include <cstdint>

namespace suture {

/// A stamp of the peer on this process's clock, but not later than now: what has not happened yet
/// would have a negative age, and such a command would never be late. 0: the peer does not say.
/// Any thread.
inline Time arrivalStamp(const Channel& channel, std::int64_t stamp) {
  const Time received = now();
  if (stamp == 0) return received;
  return std::clamp(fromNanoseconds(rpc::shifted(stamp, channel.clockShift())), Time{}, received);
}

}  // namespace suture
