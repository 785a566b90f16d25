#pragma once
// This is a connected socket with what protects it.

#include <kj/exception.h>
#include <kj/io.h>
#include <suture/net/descriptor_passing.h>
#include <suture/net/peer_identity.h>
#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace suture::tls {
class Session;
}

namespace suture::net {

/// One thread. Sends and receives bytes over a non-blocking stream socket: as they are or, with a
/// session, inside TLS.
class ByteStream {
 public:
  /// `session` is null for a plain socket; else it is on this socket and its handshake is done.
  ByteStream(kj::AutoCloseFd socket, std::unique_ptr<tls::Session> session);
  ByteStream(kj::AutoCloseFd socket);  // NOLINT(google-explicit-constructor): it is one
  ByteStream(ByteStream&& other) noexcept;
  ~ByteStream();

  /// Keeps `what` until the socket is closed.
  void attach(std::shared_ptr<void> what) { attached_ = std::move(what); }

  /// Returns the socket for event ports to wait on.
  int socket() const { return socket_; }
  PeerIdentity peer() const;
  /// Keep the address that this end has dialled, for what is told of the peer; "": it has not.
  void setDialled(std::string address) { dialled_ = std::move(address); }
  const std::string& dialled() const { return dialled_; }
  /// Returns when the certificate of the peer ends, as tls::ending() does; "" outside TLS.
  std::string certificatesEnd() const;

  /// Do what recv(2) and send(2) do. Descriptors travel too if carriesDescriptors(); otherwise they
  /// are left out.
  ssize_t receive(std::span<std::byte> into, Descriptors& descriptors);
  ssize_t send(std::span<const std::byte> bytes, const Descriptors& descriptors);
  /// Returns true for a plain Unix socket, where both ends are on one machine.
  bool carriesDescriptors() const;
  /// Returns true if a receive that fills less than it could has emptied the socket.
  bool shortMeansEmpty() const { return session_ == nullptr; }

  /// Tells the peer that no more will be sent.
  void end();
  /// Closes both directions.
  void cut();

  /// Returns an exception that says what the errno of a receive or send means.
  kj::Exception lost(int error) const;

 private:
  std::shared_ptr<void> attached_;  // first: it goes after the socket
  kj::AutoCloseFd socket_;
  std::unique_ptr<tls::Session> session_;
  std::string dialled_;
};

}  // namespace suture::net
