#pragma once
// This lets OpenSSL read and write a socket of ours.

#include <suture/net/tls/openssl.h>

namespace suture::tls {

/// Returns a method like OpenSSL's own for sockets, except that a peer that is gone raises no
/// signal. Throws std::bad_alloc.
BioMethodPtr makeSocketMethod();

/// Returns a BIO that reads and writes `socket`, which it does not own.
BioPtr makeSocketBio(const BIO_METHOD* method, int socket);

}  // namespace suture::tls
