#include "bench/network/bare_fan_out.h"

#include <suture/base/time.h>
#include <sys/epoll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <thread>

#include "bench/fail.h"
#include "bench/network/processor_time.h"
#include "bench/table2/connected_sockets.h"

namespace bench {
namespace {

using suture::now;
using suture::Time;

struct Sockets {
  std::vector<int> sending, receiving;

  explicit Sockets(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const SocketPair ends = connectedSockets(Transport::Unix);
      sending.push_back(ends[0]);
      receiving.push_back(ends[1]);
    }
  }
};

/// Receives until all values are there.
std::vector<std::int64_t> receive(const Sockets& sockets, std::vector<char> message,
                                  std::size_t values) {
  const int poll = epoll_create1(0);
  for (const int socket : sockets.receiving) {
    epoll_event event{.events = EPOLLIN, .data = {.fd = socket}};
    epoll_ctl(poll, EPOLL_CTL_ADD, socket, &event);
  }
  std::vector<std::int64_t> ages;
  ages.reserve(values);
  std::array<epoll_event, 64> ready;
  while (ages.size() < values) {
    const int count = epoll_wait(poll, ready.data(), ready.size(), -1);
    for (int i = 0; i < count; ++i) {
      const int socket = ready[static_cast<std::size_t>(i)].data.fd;
      if (recv(socket, message.data(), message.size(), 0) <= 0) return ages;
      Time stamp;
      std::memcpy(&stamp, message.data(), sizeof(stamp));
      ages.push_back((now() - stamp).count());
    }
  }
  return ages;
}

void sendRounds(const Sockets& sockets, std::vector<char>& message, std::size_t rounds) {
  Time due = now();
  for (std::size_t round = 0; round < rounds; ++round) {
    std::this_thread::sleep_until(due += std::chrono::milliseconds(1));
    const Time stamp = now();
    std::memcpy(message.data(), &stamp, sizeof(stamp));
    for (const int socket : sockets.sending) {
      if (send(socket, message.data(), message.size(), MSG_NOSIGNAL) < 0) fail("a message");
    }
  }
}

void writeAll(int pipe, const std::vector<std::int64_t>& values) {
  const auto* bytes = reinterpret_cast<const char*>(values.data());
  for (std::size_t sent = 0, size = values.size() * sizeof(values[0]); sent < size;) {
    const ssize_t count = write(pipe, bytes + sent, size - sent);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

std::vector<std::int64_t> readAll(int pipe) {
  std::vector<std::int64_t> values;
  std::array<std::int64_t, 4096> chunk;
  std::size_t filled = 0;
  for (;;) {
    const ssize_t count =
        read(pipe, reinterpret_cast<char*>(chunk.data()) + filled, sizeof(chunk) - filled);
    if (count <= 0) return values;
    filled += static_cast<std::size_t>(count);
    const std::size_t whole = filled / sizeof(chunk[0]);
    values.insert(values.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(whole));
    std::memmove(chunk.data(), chunk.data() + whole, filled % sizeof(chunk[0]));
    filled %= sizeof(chunk[0]);
  }
}

}  // namespace

FanOut bareFanOut(std::size_t bytes, std::size_t receivers, std::size_t rounds) {
  const Sockets sockets(receivers);
  std::vector<char> message(bytes);
  std::array<int, 2> result{};
  if (pipe(result.data()) != 0) fail("a pipe");
  const pid_t other = fork();
  if (other < 0) fail("a second process");
  if (other == 0) {
    for (const int socket : sockets.sending) close(socket);
    writeAll(result[1], receive(sockets, message, receivers * rounds));
    _exit(0);
  }
  close(result[1]);
  for (const int socket : sockets.receiving) close(socket);
  prctl(PR_SET_TIMERSLACK, 1UL);  // as a periodic task
  const Time begin = now();
  const double used = processorTime(getpid()) + processorTime(other);
  sendRounds(sockets, message, rounds);
  const double spent = processorTime(getpid()) + processorTime(other) - used;
  const double seconds = std::chrono::duration<double>(now() - begin).count();
  prctl(PR_SET_TIMERSLACK, 0UL);  // as before
  for (const int socket : sockets.sending) close(socket);
  FanOut out{.ages = readAll(result[0]), .load = 100 * spent / seconds};
  close(result[0]);
  waitpid(other, nullptr, 0);
  return out;
}

}  // namespace bench
