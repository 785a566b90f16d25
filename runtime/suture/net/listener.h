#pragma once
// Waits for connections at an address.

#include <kj/function.h>
#include <kj/io.h>
#include <suture/loop/event_port.h>
#include <suture/net/address.h>

#include <sys/types.h>

namespace suture::rpc {

/// A listening socket. Belongs to the control thread.
///
/// Unix: the socket file is readable and writable by its owner only, unless it opens to others; one
/// that a dead process left behind is replaced, one that somebody answers at is an error. It is
/// removed at the end. TCP: port 0 picks a free port.
class Listener {
 public:
  /// Unix: whose processes can connect. Whoever accepts others asks who they are.
  enum class Opens { ToOwner, ToOthers };

  /// Throws SetupError: in use, no such directory, no permission.
  Listener(EventPort& port, const Address& address, Opens opens = Opens::ToOwner);
  ~Listener() noexcept(false);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// True for the address of a socket file that nobody answers at. Any thread.
  static bool isStale(const Address& address);

  /// Where it really listens.
  const Address& address() const { return address_; }

  /// Hands every connection (non-blocking, TCP without delay) to `accept`. The promise never
  /// resolves; dropping it stops. Running out of descriptors or memory delays acceptance, it
  /// does not end it; `starved` hears of each such attempt.
  kj::Promise<void> listen(
      kj::Function<void(kj::AutoCloseFd)> accept, kj::Function<void(int)> starved = [](int) {});

 private:
  kj::Promise<void> acceptAll();

  EventPort& port_;
  Address address_;
  kj::AutoCloseFd socket_;
  EventPort::FdObserver observer_;
  kj::Function<void(kj::AutoCloseFd)> accept_ = [](kj::AutoCloseFd) {};
  kj::Function<void(int)> starved_ = [](int) {};
  ino_t inode_ = 0;
};

}  // namespace suture::rpc
