#pragma once
// The stream under test holds one end of a socket pair; the test plays the peer on the other.

#include <gtest/gtest.h>
#include <suture/framing/message_stream.h>
#include <suture/loop/failure.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "support/socket_pair.h"

namespace suture::framing {

inline constexpr const char* kSilent =
    "see what the process at the other end says and does: it holds the connection open, and has "
    "sent nothing for seconds. It hangs, has been stopped, or has no file descriptor left";
inline constexpr const char* kUnfinished =
    "see what the process at the other end says and does: it began a message, and has not finished "
    "it for seconds. It hangs, has been stopped, or the network between the two is cut";

/// A StreamAndPeer is the stream, and the socket on which the test plays its peer.
class StreamAndPeer : public testing::Test {
 public:
  ~StreamAndPeer() noexcept override {}

 protected:
  void open(StreamLimits limits = {}, StrangerGuard guard = {}) {
    auto pair = makeSocketPair();
    peer_ = kj::mv(pair.theirs);
    stream_ = kj::heap<MessageStream>(port_, kj::mv(pair.ours), limits,
                                      std::span<const std::byte>(), std::move(guard));
  }

  auto read() { return stream_->read(); }

  /// Returns the size of the blob in the next message, or -1 at the end of the stream.
  std::int64_t nextBlob() {
    auto message = bounded(read()).wait(port_.scope());
    KJ_IF_MAYBE (reader, message) {
      return static_cast<std::int64_t>((*reader)->getBody().getAs<capnp::Data>().size());
    }
    return -1;
  }

  /// Returns the text of the exception that the next read ends with.
  std::string nextFault() {
    try {
      auto message = bounded(read()).wait(port_.scope());
      return message == nullptr ? "end of stream" : "a message";
    } catch (const kj::Exception& e) {
      EXPECT_EQ(e.getType(), kj::Exception::Type::DISCONNECTED);
      return loop::describe(e);
    }
  }

  template <class T>
  kj::Promise<T> bounded(kj::Promise<T> promise) {
    return port_.getTimer().timeoutAfter(10 * kj::SECONDS, kj::mv(promise));
  }

  loop::EventPort port_;
  kj::AutoCloseFd peer_;
  kj::Own<MessageStream> stream_;
};

}  // namespace suture::framing
