#include <fcntl.h>
#include <gtest/gtest.h>
#include <suture/framing/message_stream.h>

#include <array>

#include "support/allocations.h"
#include "support/socket_pair.h"

namespace suture::rpc {
namespace {

constexpr unsigned kShort = 100'000;
constexpr unsigned kImage = 1u << 20;

class SendingTest : public testing::Test {
 public:
  ~SendingTest() noexcept override {}

 protected:
  /// Writes a message while the socket is full, so that all of it waits in the stream, then lets it
  /// leave. Returns how often the write allocated.
  std::uint64_t allocationsOf(unsigned bytes) {
    capnp::MallocMessageBuilder message;
    message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(bytes);
    while (send(full_, block_.data(), block_.size(), MSG_NOSIGNAL) > 0) continue;
    const std::uint64_t sent = stream_.counters()->sentBytes;
    const std::uint64_t before = allocations();
    stream_.write(message.getSegmentsForOutput());
    const std::uint64_t count = allocations() - before;
    while (stream_.counters()->sentBytes < sent + bytes) {
      empty();
      port_.scope().poll();
    }
    empty();
    return count;
  }

 private:
  void empty() {
    while (recv(pair_.theirs, block_.data(), block_.size(), 0) > 0) continue;
  }

  loop::EventPort port_;
  SocketPair pair_ = makeSocketPair();
  const kj::AutoCloseFd full_{fcntl(pair_.ours, F_DUPFD_CLOEXEC, 0)};
  framing::MessageStream stream_{port_, kj::mv(pair_.ours)};
  std::array<std::byte, 65'536> block_{};
};

// To wait for room allocates by itself; once an image has been sent, no message takes more.
TEST_F(SendingTest, AnImageTakesNoMemoryAnew) {
  allocationsOf(kImage);
  const std::uint64_t first = allocationsOf(kShort);
  const std::uint64_t second = allocationsOf(kShort);
  EXPECT_EQ(first, second);
  EXPECT_EQ(allocationsOf(kImage), second);
}

}  // namespace
}  // namespace suture::rpc
