#pragma once
// This waits for connections at an address.

#include <kj/function.h>
#include <kj/io.h>
#include <kj/time.h>
#include <suture/loop/event_port.h>
#include <suture/net/address.h>

#include <sys/types.h>

namespace suture::net {

/// Belongs to the control thread. A Listener is a listening socket.
///
/// Unix: only the owner of the socket file can read and write it, unless it opens to others. A file
/// that a dead process left behind is replaced; one at which somebody answers, or begins to listen,
/// is an error. The file is removed at the end. TCP: port 0 picks a free port.
class Listener {
 public:
  /// Says, for Unix sockets, the processes of which users can connect. A caller that opens to
  /// others must ask who they are.
  enum class Opens { ToOwner, ToOthers };

  /// Throws SetupError if the address is in use, there is no such directory, or there is no
  /// permission.
  Listener(loop::EventPort& port, const Address& address, Opens opens = Opens::ToOwner);
  ~Listener() noexcept(false);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// The file of this name behind that of a Unix socket is locked until somebody listens there.
  static constexpr std::string_view kLockEnd = ".bind";

  /// Any thread. Removes what a process has left at the address of a Unix socket, unless one
  /// listens there or is about to.
  static void removeLeftover(const Address& address);

  /// Returns where it really listens, with the port that was picked.
  const Address& address() const { return address_; }

  /// Hands every connection (non-blocking, TCP without delay) to `accept`. The promise never
  /// resolves; dropping it stops this. While the kernel refuses, for want of descriptors or for any
  /// other reason, it tries again and again, and `starved` is called with the errno of each
  /// attempt.
  kj::Promise<void> listen(
      kj::Function<void(kj::AutoCloseFd)> accept, kj::Function<void(int)> starved = [](int) {});

 private:
  kj::Promise<void> acceptAll();
  kj::Promise<void> acceptLater(kj::Duration pause);

  loop::EventPort& port_;
  Address address_;
  kj::AutoCloseFd socket_;
  loop::EventPort::FdObserver observer_;
  kj::Function<void(kj::AutoCloseFd)> accept_ = [](kj::AutoCloseFd) {};
  kj::Function<void(int)> starved_ = [](int) {};
  ino_t inode_ = 0;
};

}  // namespace suture::net
