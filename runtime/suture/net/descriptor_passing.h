#pragma once
// This sends file descriptors along with the bytes of a Unix socket.

#include <kj/array.h>
#include <kj/io.h>

#include <sys/types.h>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace suture::net {

using Descriptors = std::vector<kj::AutoCloseFd>;

/// Limits the descriptors of one message; any more are closed unseen.
inline constexpr std::size_t kMostDescriptors = 8;

/// Does what send() does, without SIGPIPE; `descriptors` go with the first byte.
ssize_t sendWith(int socket, std::span<const std::byte> bytes, const Descriptors& descriptors);
/// Does what recv() does, and adds the descriptors that have come to `descriptors`. The kernel
/// delivers the descriptors of one send, with its first bytes, and then nothing behind them in the
/// same receive.
ssize_t receiveWith(int socket, std::span<std::byte> space, Descriptors& descriptors);

/// Keeps descriptors that belong to a place in the stream, which is the number of bytes before it:
/// either they are still to be sent, or they have been received and not been taken.
class AttachedDescriptors {
 public:
  struct Attached {
    std::uint64_t begin, end;  ///< the range of the bytes that they belong to
    Descriptors descriptors;
  };

  bool empty() const { return waiting_.empty(); }
  std::size_t size() const { return waiting_.size(); }
  const Attached& front() const { return waiting_.front(); }
  void pop() { waiting_.pop_front(); }
  /// Adds one behind the others.
  void add(Attached attached) { waiting_.push_back(kj::mv(attached)); }
  /// Takes all that belong to bytes before `end`.
  kj::Array<kj::AutoCloseFd> takeUntil(std::uint64_t end);

 private:
  std::deque<Attached> waiting_;
};

/// Duplicates `descriptors`. Those that cannot be duplicated are left out.
Descriptors duplicate(kj::ArrayPtr<const int> descriptors);

}  // namespace suture::net
