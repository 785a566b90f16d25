#pragma once
// This tells when a full socket takes bytes again.

#include <fcntl.h>
#include <kj/io.h>
#include <suture/loop/event_port.h>

namespace suture::rpc {

/// Registers a socket with the event port a second time, through a duplicate descriptor: one
/// registration cannot change what it observes, and observing writability all the time costs a
/// wake-up for every read of the peer. The duplicate keeps the connection open, so destroy this
/// with the socket, not after it.
class WriteObserver {
 public:
  WriteObserver(EventPort& port, int socket)
      : duplicate_(fcntl(socket, F_DUPFD_CLOEXEC, 0)),
        observer_(port, duplicate_, EventPort::FdObserver::OBSERVE_WRITE) {}

  /// Call it only when a send has just said that the socket is full.
  kj::Promise<void> whenWritable() { return observer_.whenBecomesWritable(); }

 private:
  kj::AutoCloseFd duplicate_;
  EventPort::FdObserver observer_;
};

}  // namespace suture::rpc
