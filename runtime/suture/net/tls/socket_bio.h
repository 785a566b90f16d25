#pragma once
// How OpenSSL reads and writes a socket of ours.

#include <suture/net/tls/openssl.h>

namespace suture::tls {

/// As OpenSSL's own for sockets, but a peer that is gone raises no signal. Throws std::bad_alloc.
BioMethodPtr makeSocketMethod();

/// Reads and writes `socket`, which it does not own.
BioPtr makeSocketBio(const BIO_METHOD* method, int socket);

}  // namespace suture::tls
