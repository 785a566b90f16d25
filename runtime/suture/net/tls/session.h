#pragma once
// TLS 1.3 on a connected socket, both sides with a certificate.

#include <suture/net/tls/keys.h>
#include <suture/net/tls/openssl.h>
#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace suture::tls {

/// Why there is no TLS with a peer: what was found and what to do.
class HandshakeError : public std::runtime_error {
 public:
  enum class Cause { Broken, Refused };  ///< the connection; what one side thinks of the other

  HandshakeError(Cause why, const std::string& text) : runtime_error(text), cause(why) {}

  const Cause cause;
};

/// One connection. Never blocks: the socket is non-blocking, and whoever owns it waits for it. Used
/// by one thread at a time.
class Session {
 public:
  enum class Side { Client, Server };
  enum class Progress { Done, WantsRead, WantsWrite };

  /// `socket` stays the caller's, and outlives this.
  Session(std::shared_ptr<const Keys> keys, Side side, int socket);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Goes on as far as the socket allows. Done: each side has accepted the certificate of the other
  /// one. Throws HandshakeError.
  Progress handshake();
  /// The process whose certificate the peer has, once the handshake is done.
  const std::string& peer() const { return peer_; }

  /// As recv(2) and send(2): the number of bytes; 0: the peer has said that it is done; -1: errno,
  /// of which EPROTO is explained by failure(). A short count says nothing about what is left.
  ssize_t receive(std::span<std::byte> into);
  ssize_t send(std::span<const std::byte> bytes);
  const std::string& failure() const { return failure_; }

  /// Tells the peer that nothing more will come, if the socket takes it.
  void end();

 private:
  friend class Keys;

  static int checkCertificate(int sound, X509_STORE_CTX* check);
  static int ticketArrived(SSL* ssl, SSL_SESSION* ticket);
  Progress awaitAcceptance();
  Progress paused(int result);
  void sendTlsAlert() const;
  void requireName();
  ssize_t stopped(int result);
  std::string explain(unsigned long error) const;

  const std::shared_ptr<const Keys> keys_;
  const Side side_;
  SslPtr ssl_;
  bool named_ = false, accepted_ = false;
  std::string peer_, certificateFault_, failure_;
};

}  // namespace suture::tls
