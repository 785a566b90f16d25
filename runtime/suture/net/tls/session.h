#pragma once
// This is TLS 1.3 on a connected socket, with a certificate on both sides.

#include <suture/net/tls/keys.h>
#include <suture/net/tls/openssl.h>
#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace suture::tls {

/// Says why there is no TLS with a peer: what was found and what to do.
class HandshakeError : public std::runtime_error {
 public:
  enum class Cause { Broken, Refused };  ///< the connection broke; one side refused the other

  HandshakeError(Cause why, const std::string& text) : runtime_error(text), cause(why) {}

  const Cause cause;
};

/// One thread at a time. A Session is one TLS connection. Never blocks: the socket is non-blocking,
/// and its owner waits for it.
class Session {
 public:
  enum class Side { Client, Server };
  enum class Progress { Done, WantsRead, WantsWrite };

  /// The caller keeps `socket`, which must outlive this.
  Session(std::shared_ptr<const Keys> keys, Side side, int socket);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Goes on as far as the socket allows. Returns Done once each side has accepted the certificate
  /// of the other. Throws HandshakeError.
  Progress handshake();
  /// Returns the process that the peer's certificate names, once the handshake is done.
  const std::string& peer() const { return peer_; }
  /// Returns the peer's certificate, once the handshake is done.
  const X509* certificate() const { return shown_.get(); }

  /// Do what recv(2) and send(2) do. Return the number of bytes; 0 if the peer has said that it is
  /// done; -1 with an errno, where failure() explains EPROTO. After a short count there may be more
  /// to receive, or room for more.
  ssize_t receive(std::span<std::byte> into);
  ssize_t send(std::span<const std::byte> bytes);
  const std::string& failure() const { return failure_; }

  /// Tells the peer that nothing more will come, if the socket has room for that.
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
  CertificatePtr shown_;
  bool named_ = false, accepted_ = false;
  std::string peer_, certificateFault_, failure_;
};

}  // namespace suture::tls
