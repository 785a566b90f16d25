#pragma once
// File descriptors that travel with the bytes of a Unix socket.

#include <kj/array.h>
#include <kj/io.h>

#include <sys/types.h>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace suture::rpc {

using Descriptors = std::vector<kj::AutoCloseFd>;

/// More than these in one message are closed unseen.
inline constexpr std::size_t kMostDescriptors = 8;

/// As send(), without SIGPIPE; `descriptors` go with the first byte.
ssize_t sendWith(int socket, std::span<const std::byte> bytes, const Descriptors& descriptors);
/// As recv(); adds those that have come to `descriptors`. The kernel gives those of one send, with
/// its first bytes, which are then the last that are received.
ssize_t receiveWith(int socket, std::span<std::byte> space, Descriptors& descriptors);

/// Those that have been sent or received and still belong to a place in the stream: the number of
/// bytes before it.
class AttachedDescriptors {
 public:
  struct Attached {
    std::uint64_t begin, end;  ///< of the bytes that they belong to
    Descriptors descriptors;
  };

  bool empty() const { return waiting_.empty(); }
  std::size_t size() const { return waiting_.size(); }
  const Attached& front() const { return waiting_.front(); }
  void pop() { waiting_.pop_front(); }
  /// Adds it behind the others.
  void add(Attached attached) { waiting_.push_back(kj::mv(attached)); }
  /// Takes all that belong to bytes before `end`.
  kj::Array<kj::AutoCloseFd> takeUntil(std::uint64_t end);

 private:
  std::deque<Attached> waiting_;
};

/// Own handles of `descriptors`. Those that cannot be had are left out.
Descriptors duplicate(kj::ArrayPtr<const int> descriptors);

}  // namespace suture::rpc
