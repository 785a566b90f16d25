#include <netinet/in.h>
#include <netinet/tcp.h>
#include <suture/transport/rpc/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::rpc {

kj::AutoCloseFd openSocket(const Address& address) {
  const int opened =
      socket(SocketAddress(address).family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (opened < 0) {
    throw SetupError("open a socket for " + address.text(), std::strerror(errno),
                     "Raise the limit of open files (ulimit -n).");
  }
  return kj::AutoCloseFd(opened);
}

void sendWithoutDelay(int socket) {
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
}

}  // namespace suture::rpc
