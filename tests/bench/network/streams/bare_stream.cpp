#include "bench/network/streams/bare_stream.h"

#include <suture/base/time.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

#include "bench/fail.h"
#include "bench/placement.h"
#include "bench/table2/connected_sockets.h"

namespace bench {
namespace {

/// Takes so many bytes, then says so with one.
void takeAll(int socket, std::size_t bytes) {
  std::vector<char> space(64u << 10);
  while (bytes > 0) {
    const ssize_t count = recv(socket, space.data(), space.size(), 0);
    if (count <= 0) return;
    bytes -= static_cast<std::size_t>(count);
  }
  send(socket, space.data(), 1, MSG_NOSIGNAL);
}

}  // namespace

double bareStream(Transport transport, std::size_t bytes, int cpu, int otherCpu,
                  std::size_t messages) {
  const Pinned pinned(cpu);
  const SocketPair ends = connectedSockets(transport);
  const pid_t receiver = fork();
  if (receiver < 0) fail("a second process");
  if (receiver == 0) {
    close(ends[0]);
    const Pinned there(otherCpu);
    takeAll(ends[1], bytes * messages);
    _exit(0);
  }
  close(ends[1]);
  std::vector<char> message(bytes);
  const suture::Time begin = suture::now();
  for (std::size_t i = 0; i < messages; ++i) {
    const ssize_t sent = send(ends[0], message.data(), bytes, MSG_NOSIGNAL);
    if (sent != static_cast<ssize_t>(bytes)) fail("a stream of messages");
  }
  if (recv(ends[0], message.data(), 1, 0) != 1) fail("the end of a stream");
  const auto elapsed = static_cast<double>((suture::now() - begin).count());
  close(ends[0]);
  waitpid(receiver, nullptr, 0);
  return 1e3 * static_cast<double>(messages) / elapsed;
}

}  // namespace bench
