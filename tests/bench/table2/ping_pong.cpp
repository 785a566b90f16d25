#include "bench/table2/ping_pong.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/fail.h"
#include "bench/placement.h"

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

bool sendAll(int socket, const std::vector<char>& message) {
  return send(socket, message.data(), message.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(message.size());
}

bool receiveAll(int socket, std::vector<char>& message) {
  return recv(socket, message.data(), message.size(), MSG_WAITALL) ==
         static_cast<ssize_t>(message.size());
}

}  // namespace

SocketPair connectedSockets(Transport transport) {
  return transport == Transport::Tcp ? tcpPair() : unixPair();
}

std::vector<std::int64_t> pingPong(Transport transport, std::size_t bytes, std::optional<int> cpu,
                                   std::size_t skip, std::size_t samples) {
  const Pinned pinned(cpu);
  const SocketPair ends = connectedSockets(transport);
  std::vector<char> message(bytes);
  std::vector<std::int64_t> elapsed;
  elapsed.reserve(samples);
  const pid_t echo = fork();
  if (echo < 0) fail("a second process");
  if (echo == 0) {
    close(ends[0]);
    while (receiveAll(ends[1], message) && sendAll(ends[1], message)) {
    }
    _exit(0);
  }
  close(ends[1]);
  for (std::size_t i = 0; i < skip + samples; ++i) {
    const suture::Time begin = suture::now();
    if (!sendAll(ends[0], message) || !receiveAll(ends[0], message)) fail("a message and its echo");
    if (i >= skip) elapsed.push_back((suture::now() - begin).count());
  }
  close(ends[0]);
  waitpid(echo, nullptr, 0);
  return elapsed;
}

}  // namespace bench
