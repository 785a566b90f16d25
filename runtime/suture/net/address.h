#pragma once
// This says where a process can be reached: "unix:/path", "tls://host:port" or "tcp://host:port".

#include <suture/base/errors.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdint>
#include <string>
#include <vector>

namespace suture::net {

/// This is a parsed address, a value.
struct Address {
  enum class Kind : std::uint8_t { Unix, Tcp, Tls };

  /// Throws SetupError if the text is of no such form, if the path is longer than a socket allows
  /// or contains a comma, if the host can be neither a number nor a name, or if it is plain TCP to
  /// what may lie beyond this machine, unless that is asked for: "tcp://192.168.1.5:7700?insecure".
  static Address parse(const std::string& text);

  /// Returns the form that parse() takes.
  std::string text() const;
  /// Returns true if it needs no name service.
  bool isNumeric() const;
  /// Returns true if it is a number that leads to this machine only.
  bool isLoopback() const;

  Kind kind = Kind::Unix;
  std::string path;  ///< Unix
  std::string host;  ///< Tcp and Tls: a number, or a name for lookUp(); localhost is 127.0.0.1
  std::uint16_t port = 0;
  bool insecure = false;  ///< Tcp: may lead beyond this machine
};

/// Parses one address or several, separated by commas: "tls://10.0.0.1:7700,tls://10.0.0.2:7700".
/// Throws SetupError as Address::parse() does, or if they are not of one kind: an attacker who
/// keeps us from the first must not lead us to one that is less safe.
std::vector<Address> parseAddresses(const std::string& text);

/// Returns the address of this end of `socket`, which leads to `far`: of the same kind, with port
/// 0. For Unix sockets it is `far`.
Address localAddress(const Address& far, int socket);

/// A SocketAddress is the kernel's form of an Address. Throws SetupError if that is not numeric, or
/// its path is longer than a socket allows.
struct SocketAddress {
  explicit SocketAddress(const Address& address);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
  int family() const { return storage.ss_family; }

  sockaddr_storage storage{};
  socklen_t length = 0;
};

}  // namespace suture::net
