#pragma once
// A connected socket with what protects it.

#include <kj/exception.h>
#include <kj/io.h>
#include <suture/net/descriptor_passing.h>
#include <suture/net/peer_identity.h>
#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <span>

namespace suture::tls {
class Session;
}

namespace suture::rpc {

/// Bytes over a non-blocking stream socket: as they are or, with a session, inside TLS. One thread.
class ByteStream {
 public:
  /// Plain; or with a session on this socket, whose handshake is done.
  ByteStream(kj::AutoCloseFd socket, std::unique_ptr<tls::Session> session);
  ByteStream(kj::AutoCloseFd socket);  // NOLINT(google-explicit-constructor): it is one
  ByteStream(ByteStream&& other) noexcept;
  ~ByteStream();

  /// For event ports.
  int socket() const { return socket_; }
  PeerIdentity peer() const;

  /// As recv(2) and send(2), with descriptors where carriesDescriptors(); elsewhere they are left
  /// out.
  ssize_t receive(std::span<std::byte> into, Descriptors& descriptors);
  ssize_t send(std::span<const std::byte> bytes, const Descriptors& descriptors);
  /// True of a plain Unix socket: both ends are on one machine.
  bool carriesDescriptors() const;
  /// True if a receive that fills less than it could has emptied the socket.
  bool shortMeansEmpty() const { return session_ == nullptr; }

  /// Tells the peer that no more will be sent.
  void end();
  /// Neither direction is used any more.
  void cut();

  /// What the errno of a receive or send means.
  kj::Exception lost(int error) const;

 private:
  kj::AutoCloseFd socket_;
  std::unique_ptr<tls::Session> session_;
};

}  // namespace suture::rpc
