#include <suture/base/errors.h>
#include <suture/net/tls/keys.h>
#include <suture/net/tls/session.h>
#include <suture/net/tls/socket_bio.h>

#include <algorithm>

namespace suture::tls {
namespace {

// This is large enough for most of what a link says in one turn.
constexpr std::size_t kReadAhead = 32u << 10;

void setUp(bool done, const char* what) {
  if (!done)
    throw SetupError(std::string("set up TLS: ") + what, lastComplaint(),
                     "Check the installation of OpenSSL 3.");
}

}  // namespace

ContextPtr Keys::makeContext() {
  ContextPtr context(SSL_CTX_new(TLS_method()));
  setUp(context != nullptr, "a context");
  SSL_CTX* const raw = context.get();
  setUp(SSL_CTX_set_min_proto_version(raw, TLS1_3_VERSION) == 1, "version 1.3");
  setUp(SSL_CTX_set1_groups_list(raw, "X25519:P-256") == 1, "groups");
  SSL_CTX_set_verify(raw, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT,
                     Session::checkCertificate);
  SSL_CTX_set_mode(raw, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  SSL_CTX_set_read_ahead(raw, 1);
  SSL_CTX_set_default_read_buffer_len(raw, kReadAhead);
  // No session is ever resumed. The one ticket of a server says that it has accepted the client's
  // certificate, which TLS 1.3 does not say in any other way.
  SSL_CTX_set_options(raw, SSL_OP_NO_TICKET | SSL_OP_NO_RENEGOTIATION);
  SSL_CTX_set_session_cache_mode(raw, SSL_SESS_CACHE_CLIENT | SSL_SESS_CACHE_NO_INTERNAL);
  SSL_CTX_set_num_tickets(raw, 1);
  SSL_CTX_sess_set_new_cb(raw, Session::ticketArrived);
  return context;
}

Keys::Keys(const std::filesystem::path& folder, std::string process)
    : files_{folder},
      process_(std::move(process)),
      socket_(makeSocketMethod()),
      context_(makeContext()) {
  const CertificatePtr ca = readCertificate(files_.caCertificate());
  const CertificatePtr certificate = readCertificate(files_.certificate(process_));
  const KeyPtr key = readKey(files_.key(process_));
  requireSound(ca.get(), certificate.get());
  if (endsSoon(ca.get())) {
    warning_ = "the CA " + files_.caCertificate().string() + " ends at " + endOf(ca.get()) +
               ". Before that, " + kReplaceCa;
  } else if (endsSoon(certificate.get())) {
    warning_ = "the certificate " + files_.certificate(process_).string() + " " +
               ending(certificate.get());
  }
  SSL_CTX* const raw = context_.get();
  setUp(X509_STORE_add_cert(SSL_CTX_get_cert_store(raw), ca.get()) == 1, "the CA");
  setUp(SSL_CTX_use_certificate(raw, certificate.get()) == 1, "the certificate");
  if (SSL_CTX_use_PrivateKey(raw, key.get()) != 1) {
    throw SetupError("use the key " + files_.key(process_).string(),
                     "it is not that of the certificate beside it: " + lastComplaint(),
                     "Remove both, and make new ones with suture keys.");
  }
}

void Keys::requireSound(X509* ca, X509* certificate) const {
  const std::string asked = "use the certificate " + files_.certificate(process_).string();
  if (const std::string name = processOf(certificate); name != process_) {
    throw SetupError(asked,
                     name.empty() ? "it names no process" : "it is that of process '" + name + "'",
                     "Make one for '" + process_ + "' with suture keys.");
  }
  const StorePtr store(X509_STORE_new());
  const StoreContextPtr check(X509_STORE_CTX_new());
  X509_STORE_add_cert(store.get(), ca);
  X509_STORE_CTX_init(check.get(), store.get(), certificate, nullptr);
  if (X509_verify_cert(check.get()) == 1) return;
  throw SetupError(asked + ": it " + whyNot(check.get()));
}

}  // namespace suture::tls
