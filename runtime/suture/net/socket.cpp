#include <netinet/in.h>
#include <netinet/tcp.h>
#include <suture/net/socket.h>

#include <cerrno>
#include <cstring>

namespace suture::net {

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

void keepUnsentShort(int socket) {
  setsockopt(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kMostUnsent, sizeof(kMostUnsent));
}

void breakWhenUnanswered(int socket, Duration limit) {
  using std::chrono::ceil, std::chrono::milliseconds, std::chrono::seconds;
  const int on = 1;
  const auto longest = static_cast<unsigned>(ceil<milliseconds>(limit).count());
  const auto idle = static_cast<int>(ceil<seconds>(limit).count());
  setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &longest, sizeof(longest));
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof(on));
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &idle, sizeof(idle));
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &on, sizeof(on));  // 1 s
}

}  // namespace suture::net
