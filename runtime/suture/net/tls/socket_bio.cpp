#include <suture/net/tls/socket_bio.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <new>

namespace suture::tls {
namespace {

int socketOf(BIO* bio) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(BIO_get_data(bio)));
}

template <class Transfer>
int transfer(BIO* bio, int retry, Transfer move) {
  BIO_clear_retry_flags(bio);
  ssize_t count = -1;
  do {
    count = move(socketOf(bio));
  } while (count < 0 && errno == EINTR);
  if (count < 0 && errno == EAGAIN) BIO_set_flags(bio, retry | BIO_FLAGS_SHOULD_RETRY);
  return static_cast<int>(count);
}

int writeSocket(BIO* bio, const char* bytes, int size) {
  return transfer(bio, BIO_FLAGS_WRITE, [&](int socket) {
    return send(socket, bytes, static_cast<std::size_t>(size), MSG_NOSIGNAL);
  });
}

int readSocket(BIO* bio, char* bytes, int size) {
  const int count = transfer(bio, BIO_FLAGS_READ, [&](int socket) {
    return recv(socket, bytes, static_cast<std::size_t>(size), 0);
  });
  if (count == 0) BIO_set_flags(bio, BIO_FLAGS_IN_EOF);
  return count;
}

long controlSocket(BIO* bio, int what, long, void*) {
  if (what == BIO_CTRL_EOF) return BIO_test_flags(bio, BIO_FLAGS_IN_EOF) != 0 ? 1 : 0;
  return what == BIO_CTRL_FLUSH ? 1 : 0;
}

}  // namespace

BioMethodPtr makeSocketMethod() {
  BioMethodPtr method(BIO_meth_new(BIO_TYPE_SOURCE_SINK | BIO_get_new_index(), "socket"));
  if (method == nullptr) throw std::bad_alloc();
  BIO_meth_set_write(method.get(), writeSocket);
  BIO_meth_set_read(method.get(), readSocket);
  BIO_meth_set_ctrl(method.get(), controlSocket);
  return method;
}

BioPtr makeSocketBio(const BIO_METHOD* method, int socket) {
  BioPtr bio(BIO_new(method));
  if (bio == nullptr) throw std::bad_alloc();
  // A BIO keeps a pointer, and this one needs a number, so the number is stored as a pointer.
  BIO_set_data(bio.get(),
               reinterpret_cast<void*>(  // NOLINT(performance-no-int-to-ptr)
                   static_cast<std::intptr_t>(socket)));
  BIO_set_init(bio.get(), 1);
  return bio;
}

}  // namespace suture::tls
