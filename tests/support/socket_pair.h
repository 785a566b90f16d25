#pragma once
// These are two connected sockets: one for a stream under test, one played by the test byte by
// byte.

#include <capnp/message.h>
#include <fcntl.h>
#include <kj/async-io.h>
#include <kj/io.h>
#include <poll.h>
#include <suture/framing/message_header.h>
#include <suture/loop/event_port.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <span>
#include <string>
#include <vector>

#include "support/patience.h"

namespace suture {

struct SocketPair {
  kj::AutoCloseFd ours;    // non-blocking, for the stream
  kj::AutoCloseFd theirs;  // non-blocking, for the test
};

inline SocketPair makeSocketPair() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) != 0) std::abort();
  return {kj::AutoCloseFd(ends[0]), kj::AutoCloseFd(ends[1])};
}

/// Stops if the connection ends.
inline void sendAll(int socket, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else {
      pollfd writable{socket, POLLOUT, 0};
      if (errno != EAGAIN || poll(&writable, 1, 5000) <= 0) return;
    }
  }
}

/// Leaves no room in a non-blocking socket.
inline void fill(int socket) {
  const std::byte bytes[4096]{};
  while (send(socket, bytes, sizeof(bytes), MSG_NOSIGNAL) > 0) {
  }
}

inline void sendText(int socket, const std::string& text) {
  sendAll(socket, std::as_bytes(std::span(text)));
}

/// Returns true if the peer ends the connection within kPatience.
inline bool closes(loop::EventPort& port, int socket) {
  loop::EventPort::FdObserver observer(port, socket, loop::EventPort::FdObserver::OBSERVE_READ);
  std::byte bytes[4096];
  for (ssize_t count = -1; count != 0;) {
    count = recv(socket, bytes, sizeof(bytes), 0);
    if (count >= 0) continue;
    if (errno != EAGAIN) return true;
    auto readable = observer.whenBecomesReadable().then([] { return true; });
    auto late =
        port.getTimer().afterDelay(kPatience.count() * kj::NANOSECONDS).then([] { return false; });
    if (!readable.exclusiveJoin(kj::mv(late)).wait(port.scope())) return false;
  }
  return true;
}

/// Returns a frame whose root is a Data blob of `size` bytes, all equal to `fill`.
inline std::vector<std::byte> blobFrame(std::size_t size, unsigned char fill = 7) {
  capnp::MallocMessageBuilder message;
  auto blob = message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(size);
  memset(blob.begin(), fill, blob.size());
  std::vector<std::byte> bytes;
  framing::appendMessage(message.getSegmentsForOutput(), bytes);
  return bytes;
}

}  // namespace suture
