#pragma once
// This tells when a full socket takes bytes again.

#include <fcntl.h>
#include <kj/io.h>
#include <suture/loop/event_port.h>
#include <suture/loop/failure.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace suture::loop {

/// Registers a socket with the event port a second time, through a duplicate descriptor: one
/// registration cannot change what it observes, and observing writability all the time costs a
/// wake-up for every read of the peer. The duplicate keeps the connection open, so destroy this
/// with the socket, not after it.
class WriteObserver {
 public:
  /// Throws kj::Exception if the process has no descriptor for it.
  WriteObserver(EventPort& port, int socket)
      : duplicate_(duplicateOf(socket)),
        observer_(port, duplicate_, EventPort::FdObserver::OBSERVE_WRITE) {}

  /// Call it only when a send has just said that the socket is full.
  kj::Promise<void> whenWritable() { return observer_.whenBecomesWritable(); }

 private:
  static kj::AutoCloseFd duplicateOf(int socket) {
    const int duplicate = fcntl(socket, F_DUPFD_CLOEXEC, 0);
    if (duplicate >= 0) return kj::AutoCloseFd(duplicate);
    kj::throwFatalException(disconnected(std::string("cannot wait until a full socket has room: ") +
                                         std::strerror(errno) +
                                         ". Raise the limit of open files (ulimit -n)."));
  }

  kj::AutoCloseFd duplicate_;
  EventPort::FdObserver observer_;
};

}  // namespace suture::loop
