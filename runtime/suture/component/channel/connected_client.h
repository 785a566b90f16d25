#pragma once
// A component learns this of the clients of its provided interfaces: Component::onClient().

#include <suture/base/time.h>

#include <cstdint>
#include <string_view>

namespace suture {

/// A ConnectedClient is one connection of a client. The provider's component sees the same object
/// from when it is told of the client until it is told that the connection has ended; a connection
/// that is made anew has another object.
struct ConnectedClient {
  ConnectedClient(std::string_view interface, Duration longestSilence)
      : name(interface), silence(longestSilence) {}
  ConnectedClient(const ConnectedClient&) = delete;
  ConnectedClient& operator=(const ConnectedClient&) = delete;

  /// Names the required interface, with its process: "console:Teleop/Slave".
  const std::string_view name;
  /// The client bears its provider's silence for so long before it loses the connection; 0: for
  /// ever, as one in the same process does, or it has not said how long.
  const Duration silence;
};

enum class ClientNews : std::uint8_t {
  Connected,
  Closed,  ///< the connection was taken down, the client's process has ended, or the link broke
  Silent,  ///< nothing came from the client's process for as long as the connection's `silence`
};

}  // namespace suture
