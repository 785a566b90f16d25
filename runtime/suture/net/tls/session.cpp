#include <openssl/err.h>
#include <suture/net/tls/session.h>
#include <suture/net/tls/socket_bio.h>

#include <cerrno>
#include <cstring>
#include <new>

namespace suture::tls {
namespace {

constexpr const char* kNotTls =
    "it does not speak TLS. Correct the address: tls:// at both ends, or at neither.";

/// Returns true if the peer complained about our certificate, by OpenSSL's numbers of complaints.
bool isAboutOurCertificate(int reason) {
  switch (reason) {
    case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_REVOKED:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN:
    case SSL_R_SSLV3_ALERT_UNSUPPORTED_CERTIFICATE:
    case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
    case SSL_R_TLSV1_ALERT_ACCESS_DENIED:
    case SSL_R_TLSV1_ALERT_DECRYPT_ERROR:
    case SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED: return true;
    default: return false;
  }
}

bool isEnd(unsigned long error) {
  return ERR_GET_LIB(error) == ERR_LIB_SSL &&
         ERR_GET_REASON(error) == SSL_R_UNEXPECTED_EOF_WHILE_READING;
}

bool isNoTls(unsigned long error) {
  if (ERR_GET_LIB(error) != ERR_LIB_SSL) return false;
  switch (ERR_GET_REASON(error)) {
    case SSL_R_WRONG_VERSION_NUMBER:
    case SSL_R_HTTP_REQUEST:
    case SSL_R_HTTPS_PROXY_REQUEST:
    case SSL_R_PACKET_LENGTH_TOO_LONG:
    case SSL_R_RECORD_LENGTH_MISMATCH:
    case SSL_R_UNEXPECTED_MESSAGE:
    case SSL_R_UNEXPECTED_RECORD:
    case SSL_R_UNSUPPORTED_PROTOCOL: return true;
    default: return false;
  }
}

}  // namespace

Session::Session(std::shared_ptr<const Keys> keys, Side side, int socket)
    : keys_(std::move(keys)), side_(side), ssl_(SSL_new(keys_->context_.get())) {
  if (ssl_ == nullptr) throw std::bad_alloc();
  BIO* const bio = makeSocketBio(keys_->socket_.get(), socket).release();
  SSL_set_bio(ssl_.get(), bio, bio);  // owns it
  SSL_set_app_data(ssl_.get(), this);
  if (side_ == Side::Client) {
    SSL_set_connect_state(ssl_.get());
  } else {
    SSL_set_accept_state(ssl_.get());
  }
}

Session::Progress Session::handshake() {
  ERR_clear_error();
  const int result = SSL_do_handshake(ssl_.get());
  if (result != 1) return paused(result);
  if (!named_) requireName();
  return side_ == Side::Server ? Progress::Done : awaitAcceptance();
}

// In TLS 1.3 the client is done before the server has looked at its certificate, so wait for that.
Session::Progress Session::awaitAcceptance() {
  char first;
  std::size_t count = 0;
  const int result = SSL_peek_ex(ssl_.get(), &first, 1, &count);
  if (accepted_ || result == 1) return Progress::Done;
  return paused(result);
}

// Keeps what is wrong with a certificate, because OpenSSL discards it.
int Session::checkCertificate(int sound, X509_STORE_CTX* check) {
  if (sound == 1) return 1;
  void* const ssl = X509_STORE_CTX_get_ex_data(check, SSL_get_ex_data_X509_STORE_CTX_idx());
  auto* const session = static_cast<Session*>(SSL_get_app_data(static_cast<SSL*>(ssl)));
  session->certificateFault_ = "its certificate " + whyNot(check);
  return 0;
}

int Session::ticketArrived(SSL* ssl, SSL_SESSION*) {
  static_cast<Session*>(SSL_get_app_data(ssl))->accepted_ = true;
  return 0;  // it is not kept
}

Session::Progress Session::paused(int result) {
  using Cause = HandshakeError::Cause;
  switch (SSL_get_error(ssl_.get(), result)) {
    case SSL_ERROR_WANT_READ: return Progress::WantsRead;
    case SSL_ERROR_WANT_WRITE: return Progress::WantsWrite;
    case SSL_ERROR_ZERO_RETURN:
      throw HandshakeError(Cause::Broken, "it closed the connection during the TLS handshake.");
    case SSL_ERROR_SYSCALL:
      throw HandshakeError(Cause::Broken,
                           std::string("the connection broke: ") + std::strerror(errno) + ".");
    default: break;
  }
  const unsigned long error = ERR_peek_error();
  if (isNoTls(error)) sendTlsAlert();
  throw HandshakeError(isEnd(error) ? Cause::Broken : Cause::Refused, explain(error));
}

// OpenSSL sends no answer to bytes that are not TLS. This sends an alert, from which an end of ours
// without TLS knows what is wrong.
void Session::sendTlsAlert() const {
  const unsigned char alert[] = {0x15, 0x03, 0x03, 0, 2, 2, SSL_AD_PROTOCOL_VERSION};
  (void)BIO_write(SSL_get_wbio(ssl_.get()), alert, sizeof(alert));
}

void Session::requireName() {
  shown_.reset(SSL_get1_peer_certificate(ssl_.get()));
  if (shown_ != nullptr) peer_ = processOf(shown_.get());
  if (peer_.empty()) {
    throw HandshakeError(HandshakeError::Cause::Refused,
                         "its certificate names no process of Suture. Make one with suture keys.");
  }
  named_ = true;
}

ssize_t Session::receive(std::span<std::byte> into) {
  ERR_clear_error();
  std::size_t count = 0;
  const int result = SSL_read_ex(ssl_.get(), into.data(), into.size(), &count);
  return result == 1 ? static_cast<ssize_t>(count) : stopped(result);
}

ssize_t Session::send(std::span<const std::byte> bytes) {
  ERR_clear_error();
  std::size_t count = 0;
  const int result = SSL_write_ex(ssl_.get(), bytes.data(), bytes.size(), &count);
  if (result == 1) return static_cast<ssize_t>(count);
  if (stopped(result) < 0) return -1;
  errno = EPIPE;
  return -1;
}

ssize_t Session::stopped(int result) {
  switch (SSL_get_error(ssl_.get(), result)) {
    case SSL_ERROR_WANT_READ:
    case SSL_ERROR_WANT_WRITE: errno = EAGAIN; return -1;
    case SSL_ERROR_ZERO_RETURN: return 0;
    case SSL_ERROR_SYSCALL:
      if (errno == 0 || errno == EAGAIN) errno = ECONNRESET;
      return -1;
    default:
      failure_ = explain(ERR_peek_error());
      errno = EPROTO;
      return -1;
  }
}

std::string Session::explain(unsigned long error) const {
  const int reason = ERR_GET_LIB(error) == ERR_LIB_SSL ? ERR_GET_REASON(error) : 0;
  const std::string said = lastComplaint();
  if (!certificateFault_.empty()) return certificateFault_;
  if (reason == SSL_R_PEER_DID_NOT_RETURN_A_CERTIFICATE) {
    return "it shows no certificate. Give it keys that suture keys made.";
  }
  if (isAboutOurCertificate(reason)) {
    return "it does not accept the certificate of '" + keys_->process() + "' (" + said +
           "). Make the keys of both with the same suture keys, and check both clocks.";
  }
  if (isEnd(error)) return "it closed the connection without a word.";
  if (isNoTls(error)) return kNotTls;
  return "TLS failed: " + said + ". Look at what the peer says about that.";
}

void Session::end() {
  ERR_clear_error();
  SSL_shutdown(ssl_.get());
  ERR_clear_error();
}

}  // namespace suture::tls
