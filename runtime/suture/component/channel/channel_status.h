#pragma once
// A channel tells both of its ends with this how their connection stands.

#include <suture/base/errors.h>
#include <suture/standard/lifecycle.h>

#include <cstdint>

namespace suture {

enum class ChannelStatus : std::uint8_t {
  Connected,
  Lost,       ///< the far end went away
  Faulted,    ///< the provider's handler threw
  Closed,     ///< this connection was taken down; both ends let go of it
  Suspended,  ///< the provider executes nothing until it is resumed, or started again
  Lapsed,     ///< provider's end: its client has not been heard of for as long as it waits
};

/// True if nothing comes through any more.
bool isOver(ChannelStatus status);

/// The error that a call through a channel of this status meets; 0 if it is connected.
Errc errorOf(ChannelStatus status);

/// The error that ends a call under way without an answer; 0 if one may still come: a suspended
/// provider answers what it was sent.
Errc endOfCalls(ChannelStatus status);

/// The status of a connection to a component in this state; Connected also before its first cycle.
ChannelStatus statusIn(ComponentState state);

}  // namespace suture
