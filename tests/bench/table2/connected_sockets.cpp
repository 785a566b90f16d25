#include "bench/table2/connected_sockets.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bench/fail.h"

namespace bench {
namespace {

SocketPair unixPair() {
  SocketPair ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail("a pair of Unix sockets");
  return ends;
}

void sendAtOnce(int socket) {
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
}

SocketPair tcpPair() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  socklen_t length = sizeof(address);
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  if (bind(listener, generic, length) != 0 || listen(listener, 1) != 0 ||
      getsockname(listener, generic, &length) != 0) {
    fail("a TCP listener on the loopback");
  }
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  if (connect(client, generic, length) != 0) fail("a TCP connection over the loopback");
  const int server = accept(listener, nullptr, nullptr);
  close(listener);
  sendAtOnce(client);
  sendAtOnce(server);
  return {client, server};
}

}  // namespace

SocketPair connectedSockets(Transport transport) {
  return transport == Transport::Tcp ? tcpPair() : unixPair();
}

}  // namespace bench
