#pragma once
// What a component learns of the clients of its provided interfaces: Component::onClient().

#include <cstdint>
#include <string_view>

namespace suture {

/// One connection of a client. Its provider's component sees the same object from when it is told
/// of the client until it is told that the connection has ended; a connection that is made anew is
/// another object.
struct ConnectedClient {
  explicit ConnectedClient(std::string_view interface) : name(interface) {}
  ConnectedClient(const ConnectedClient&) = delete;
  ConnectedClient& operator=(const ConnectedClient&) = delete;

  /// The required interface, with its process: "console:Teleop/Slave".
  const std::string_view name;
};

enum class ClientNews : std::uint8_t {
  Connected,
  Closed,  ///< the connection was taken down, the client's process has ended, or the link broke
  Silent,  ///< its process has not been heard of for as long as the connection's `silence`
};

}  // namespace suture
