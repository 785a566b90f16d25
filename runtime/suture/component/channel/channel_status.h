#pragma once
// This tells both ends of a channel the state of their connection.

#include <suture/base/errors.h>
#include <suture/standard/lifecycle.h>

#include <cstdint>

namespace suture {

enum class ChannelStatus : std::uint8_t {
  Connected,
  Lost,       ///< the far end went away
  Faulted,    ///< the provider's handler threw
  Closed,     ///< this connection was taken down; both ends drop it
  Suspended,  ///< the provider executes nothing until it is resumed, or started again
  Lapsed,     ///< provider's end: its client was silent for as long as the provider waits
};

/// Returns its name for people: "connected".
const char* toString(ChannelStatus status);

/// Returns true if nothing comes through any more.
bool isOver(ChannelStatus status);

/// Returns the error that a call through a channel of this status meets; 0 if it is connected.
Errc errorOf(ChannelStatus status);

/// Returns the error that ends a call under way without an answer, or 0 if one may still come: a
/// suspended provider answers the calls that it got.
Errc endOfCalls(ChannelStatus status);

/// Returns the status of a connection to a component in this state; Connected also before its first
/// cycle.
ChannelStatus statusIn(ComponentState state);

}  // namespace suture
