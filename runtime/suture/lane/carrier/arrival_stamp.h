#pragma once
// This says when a value that comes from a peer was made.

#include <suture/component/channel/channel.h>
#include <suture/wire/stamps.h>

#include <algorithm>
#include <cstdint>

namespace suture {

/// Any thread: turns a stamp of the peer to this process's clock, but not later than now: what has
/// not happened yet would have a negative age, and such a command would never be late. It is now
/// for 0, with which the peer does not say.
inline Time arrivalStamp(const Channel& channel, std::int64_t stamp) {
  const Time received = now();
  if (stamp == 0) return received;
  return std::clamp(fromNanoseconds(rpc::shifted(stamp, channel.clockShift())), Time{}, received);
}

}  // namespace suture
