#pragma once
// A peer that OpenSSL plays, with the certificate and key it is given, or without: it checks
// nothing, as one would that wants to get in.

#include <fcntl.h>
#include <openssl/err.h>
#include <poll.h>
#include <suture/net/tls/openssl.h>
#include <suture/net/tls/socket_bio.h>
#include <sys/socket.h>

#include <filesystem>
#include <string>

namespace suture::tls {

struct Shown {
  std::filesystem::path certificate, key;  ///< "": none
};

class Stranger {
 public:
  explicit Stranger(const Shown& shown, int newest = TLS1_3_VERSION)
      : context_(SSL_CTX_new(TLS_method())) {
    SSL_CTX_set_max_proto_version(context_.get(), newest);
    if (shown.certificate.empty()) return;
    if (SSL_CTX_use_certificate_file(context_.get(), shown.certificate.c_str(), SSL_FILETYPE_PEM) !=
            1 ||
        SSL_CTX_use_PrivateKey_file(context_.get(), shown.key.c_str(), SSL_FILETYPE_PEM) != 1) {
      std::abort();
    }
  }

  /// It asks for a certificate and refuses every one.
  void trustNobody() {
    SSL_CTX_set_verify(context_.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  }

  /// Does the handshake on a socket and waits for a byte; what it hears instead, or "accepted".
  std::string tryAt(int socket, bool asClient) {
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) & ~O_NONBLOCK);
    const SslPtr ssl(SSL_new(context_.get()));
    BIO* const bio = makeSocketBio(socket_.get(), socket).release();  // raises no signals
    SSL_set_bio(ssl.get(), bio, bio);
    ERR_clear_error();
    if ((asClient ? SSL_connect(ssl.get()) : SSL_accept(ssl.get())) != 1) return complaint();
    pollfd readable{socket, POLLIN, 0};
    char one = 0;
    while (poll(&readable, 1, 5000) > 0) {
      const int count = SSL_read(ssl.get(), &one, 1);
      if (count == 1) return "accepted";
      if (SSL_get_error(ssl.get(), count) == SSL_ERROR_ZERO_RETURN) return "closed";
      return complaint();
    }
    return "nothing";
  }

 private:
  static std::string complaint() {
    const unsigned long error = ERR_get_error();
    ERR_clear_error();
    const char* const reason = ERR_reason_error_string(error);
    return reason != nullptr ? reason : "closed";
  }

  BioMethodPtr socket_ = makeSocketMethod();
  ContextPtr context_;
};

}  // namespace suture::tls
