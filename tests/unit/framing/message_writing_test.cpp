// A stream sends what is written to it together and in order, and a peer that takes nothing costs
// little.

#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>
#include <suture/base/time.h>
#include <suture/framing/message_stream.h>
#include <suture/loop/failure.h>

#include <memory>
#include <string>

#include "stream_and_peer.h"
#include "support/contains.h"
#include "support/no_more_descriptors.h"
#include "support/patience.h"
#include "support/refusal.h"

namespace suture::framing {
namespace {

using Leaves = MessageStream::Leaves;

class MessageWritingTest : public StreamAndPeer {
 protected:
  /// Writes a message whose blob has so many bytes.
  static void writeTo(MessageStream& stream, unsigned bytes, Leaves when = Leaves::AtEndOfTurn) {
    capnp::MallocMessageBuilder message;
    message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(bytes);
    stream.write(message.getSegmentsForOutput(), when);
  }
  void write(unsigned bytes, Leaves when = Leaves::AtEndOfTurn) { writeTo(*stream_, bytes, when); }
};

TEST_F(MessageWritingTest, MessagesOfOneTurnLeaveTogether) {
  open();
  for (int i = 0; i < 3; ++i) write(16);
  port_.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port_.scope());
  std::byte bytes[1024];
  const auto frame = blobFrame(16).size();
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), static_cast<ssize_t>(3 * frame));
  EXPECT_EQ(stream_->counters()->sentBytes, 3 * frame);
}

TEST_F(MessageWritingTest, ADelayableMessageLeavesSoon) {
  open();
  const auto arrived = [this] {
    std::byte bytes[1024];
    return recv(peer_, bytes, sizeof(bytes), 0);
  };
  const auto pass = [this](int milliseconds) {
    port_.getTimer().afterDelay(milliseconds * kj::MILLISECONDS).wait(port_.scope());
  };
  write(8, Leaves::WithNextMessage);
  kj::evalLast([] {}).wait(port_.scope());
  EXPECT_EQ(arrived(), -1);
  write(16);
  kj::evalLast([] {}).wait(port_.scope());
  pass(0);
  EXPECT_EQ(arrived(), static_cast<ssize_t>(blobFrame(8).size() + blobFrame(16).size()));
  write(8, Leaves::WithNextMessage);
  kj::evalLast([] {}).wait(port_.scope());
  ssize_t alone = -1;
  for (const Time deadline = now() + kPatience; alone == -1 && now() < deadline;) {
    pass(1);
    alone = arrived();
  }
  EXPECT_EQ(alone, static_cast<ssize_t>(blobFrame(8).size()));
}

TEST_F(MessageWritingTest, AnEarlyCloseEndsBothDirections) {
  open();
  write(2 << 20);
  auto ending = stream_->end();
  EXPECT_FALSE(ending.poll(port_.scope()));
  peer_ = nullptr;
  EXPECT_THROW(bounded(kj::mv(ending)).wait(port_.scope()), kj::Exception);
  write(2 << 20);
  EXPECT_THROW(stream_->end().wait(port_.scope()), kj::Exception);
  EXPECT_NE(nextFault(), "a message");
}

TEST_F(MessageWritingTest, AStuckPeersCostIsBounded) {
  open({.unsentBytes = 3u << 20});
  auto reading = bounded(read());
  for (int i = 0; i < 3; ++i) write(1 << 20);
  EXPECT_FALSE(reading.poll(port_.scope()));  // the third fits beside what the socket has taken
  for (int i = 0; i < 2; ++i) write(1 << 20);
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
  try {
    stream_->end().wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), "the peer does not take what is sent");
  }
}

TEST_F(MessageWritingTest, AStuckStrangersCostIsBounded) {
  for (const bool becomesKnown : {false, true}) {
    const auto known = std::make_shared<bool>(false);
    open({}, {.known = known, .share = nullptr});
    auto reading = bounded(read());
    write(15 << 10);
    EXPECT_FALSE(reading.poll(port_.scope()));
    *known = becomesKnown;
    for (int i = 0; i < 2; ++i) write(15 << 10);
    EXPECT_EQ(reading.poll(port_.scope()), !becomesKnown);
  }
}

// A peer that says it is done keeps its link open until all is sent, so it could keep it for ever.
TEST_F(MessageWritingTest, AStuckPeerDelaysNoEnd) {
  open({.drainMilliseconds = 20});
  write(2 << 20);
  try {
    bounded(stream_->end()).wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), "the peer does not take what is sent");
  }
}

// The stream needs a descriptor to learn when a full socket takes bytes again.
TEST_F(MessageWritingTest, AFullSocketEndsNothingElse) {
#if defined(SUTURE_ADDRESS_SANITIZER)
  GTEST_SKIP() << "UBSan itself takes a descriptor to look at an object";
#endif
  auto pair = makeSocketPair();
  fill(pair.ours);
  MessageStream stream(port_, kj::mv(pair.ours));
  auto reading = bounded(stream.read());
  EXPECT_FALSE(reading.poll(port_.scope()));
  const NoMoreDescriptors limit;
  writeTo(stream, 8);
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
  const std::string failure = refusal([&] { stream.end().wait(port_.scope()); });
  EXPECT_TRUE(contains(failure, "Too many open files")) << failure;
}

TEST_F(MessageWritingTest, APeerThatStopsReadingIsGone) {
  open();
  auto reading = bounded(read());
  shutdown(peer_, SHUT_RD);
  write(8);
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
}

TEST_F(MessageWritingTest, EndSendsWhatIsPendingThenCloses) {
  open();
  write(16);
  bounded(stream_->end()).wait(port_.scope());
  std::byte bytes[1024];
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), static_cast<ssize_t>(blobFrame(16).size()));
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), 0);
}

}  // namespace
}  // namespace suture::framing
