#pragma once
// Where a process can be reached: "unix:/path" or "tcp://host:port".

#include <suture/base/errors.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdint>
#include <string>

namespace suture::rpc {

/// A parsed address. A value.
struct Address {
  enum class Kind : std::uint8_t { Unix, Tcp };

  /// Throws SetupError: not of either form, a path longer than a socket can have, a host that is
  /// neither a number nor localhost, or (plain TCP is for one machine only) a host that is not
  /// loopback.
  static Address parse(const std::string& text);

  /// The form that parse() takes.
  std::string text() const;

  Kind kind = Kind::Unix;
  std::string path;  ///< Unix
  std::string host;  ///< Tcp, numeric
  std::uint16_t port = 0;
};

/// The kernel's form of an Address.
struct SocketAddress {
  explicit SocketAddress(const Address& address);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
  int family() const { return storage.ss_family; }

  sockaddr_storage storage{};
  socklen_t length = 0;
};

}  // namespace suture::rpc
