#include "bench/table2/ping_pong.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/fail.h"
#include "bench/placement.h"
#include "bench/table2/connected_sockets.h"

namespace bench {
namespace {

bool sendAll(int socket, const std::vector<char>& message) {
  return send(socket, message.data(), message.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(message.size());
}

bool receiveAll(int socket, std::vector<char>& message) {
  return recv(socket, message.data(), message.size(), MSG_WAITALL) ==
         static_cast<ssize_t>(message.size());
}

}  // namespace

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
