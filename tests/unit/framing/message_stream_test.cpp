// The stream under test holds one end of a socket pair; the test plays the peer on the other.

#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>
#include <suture/base/time.h>
#include <suture/framing/message_stream.h>
#include <suture/framing/preamble.h>
#include <suture/loop/failure.h>

#include <algorithm>
#include <span>
#include <vector>

#include "support/contains.h"
#include "support/no_more_descriptors.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/resources.h"
#include "support/socket_pair.h"
#include "support/test_thread.h"

namespace suture::framing {
namespace {

constexpr const char* kSilent =
    "see what the process at the other end says and does: it holds the connection open, and has "
    "sent nothing for seconds. It hangs, has been stopped, or has no file descriptor left";
constexpr const char* kUnfinished =
    "see what the process at the other end says and does: it began a message, and has not finished "
    "it for seconds. It hangs, has been stopped, or the network between the two is cut";

class MessageStreamTest : public testing::Test {
 public:
  ~MessageStreamTest() noexcept override {}

 protected:
  void open(StreamLimits limits = {}, StrangerGuard guard = {}) {
    auto pair = makeSocketPair();
    peer_ = kj::mv(pair.theirs);
    stream_ = kj::heap<MessageStream>(port_, kj::mv(pair.ours), limits,
                                      std::span<const std::byte>(), std::move(guard));
  }

  /// The peer is bounded to so many bytes of unfinished messages.
  void openBounded(std::size_t bytes) {
    budget_ = std::make_shared<PeerBudget>(PeerBudget::Limits{.peer = bytes, .process = bytes});
    open({}, {.known = nullptr, .share = std::make_unique<PeerBudget::Share>(budget_, "the peer")});
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
  std::shared_ptr<PeerBudget> budget_;
  kj::Own<MessageStream> stream_;
};

TEST_F(MessageStreamTest, RefusesDescriptorsThatNoMessageBrings) {
  open();
  const std::vector<std::byte> frame = blobFrame(4096);
  for (std::size_t i = 0; i <= net::kMostDescriptors; ++i) {
    net::Descriptors one;
    one.push_back(kj::AutoCloseFd(dup(peer_)));
    ASSERT_EQ(net::sendWith(peer_, std::span(frame).subspan(i, 1), one), 1);
  }
  EXPECT_EQ(nextFault(), "the peer sends more descriptors than messages");
}

TEST(Preamble, APeerThatIsGoneTakesNone) {
  loop::EventPort port;
  auto pair = makeSocketPair();
  pair.theirs = nullptr;
  const std::string error = refusal(
      [&] { exchangeToken(port, net::ByteStream(kj::mv(pair.ours)), Token{}).wait(port.scope()); });
  EXPECT_TRUE(contains(error, "the second connection takes nothing")) << error;
}

TEST(Preamble, ASilentPeerIsToldAsOne) {
  loop::EventPort port;
  auto pair = makeSocketPair();
  const std::string error = refusal([&] {
    readPreamble(port, net::ByteStream(kj::mv(pair.ours)), {.firstMilliseconds = 20})
        .wait(port.scope());
  });
  EXPECT_TRUE(contains(error, kSilent)) << error;
}

TEST_F(MessageStreamTest, RefusesTheAdvisoryFrame) {
  open();
  sendAll(peer_, std::vector(16, std::byte{0xff}));
  EXPECT_EQ(nextFault(), toString(FrameFault::TooManySegments));
}

TEST_F(MessageStreamTest, RefusesAPeerThatSendsText) {
  open();
  sendText(peer_, "GET / HTTP/1.1\r\nHost: robot\r\n\r\n");
  EXPECT_EQ(nextFault(), toString(FrameFault::TooManySegments));
}

TEST_F(MessageStreamTest, RefusesAHugeLengthAtOnce) {
  open();
  const std::uint32_t words[2] = {0, 0xffffffff};
  sendAll(peer_, std::as_bytes(std::span(words)));
  EXPECT_EQ(nextFault(), toString(FrameFault::TooLong));
}

TEST_F(MessageStreamTest, EveryRandomStartEndsInTime) {
  std::uint64_t state = 42;
  for (int round = 0; round < 200; ++round) {
    open({.partialMilliseconds = 1, .firstMilliseconds = 1});
    std::vector<std::byte> bytes(64);
    for (auto& byte : bytes) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      byte = static_cast<std::byte>(state >> 56);
    }
    sendAll(peer_, bytes);
    const std::string fault = nextFault();
    EXPECT_TRUE(fault == toString(FrameFault::TooManySegments) ||
                fault == toString(FrameFault::TooLong) || fault == kUnfinished)
        << fault;
  }
}

TEST_F(MessageStreamTest, HalfAHeaderEndsAtTheDeadline) {
  open({.partialMilliseconds = 20, .firstMilliseconds = 0});
  sendAll(peer_, std::vector(2, std::byte{0}));
  EXPECT_EQ(nextFault(), kUnfinished);
}

TEST_F(MessageStreamTest, AMissingBodyEndsAtTheDeadline) {
  open({.partialMilliseconds = 20, .firstMilliseconds = 0});
  sendAll(peer_, blobFrame(8));
  EXPECT_EQ(nextBlob(), 8);
  const std::uint32_t words[2] = {0, 1000};
  sendAll(peer_, std::as_bytes(std::span(words)));
  EXPECT_EQ(nextFault(), kUnfinished);
}

TEST_F(MessageStreamTest, SilenceEndsAtTheFirstMessageDeadline) {
  open({.firstMilliseconds = 20});
  EXPECT_EQ(nextFault(), kSilent);
}

TEST_F(MessageStreamTest, AnIdleConnectionMayStaySilent) {
  open({.partialMilliseconds = 1, .firstMilliseconds = 1});
  sendAll(peer_, blobFrame(8));
  EXPECT_EQ(nextBlob(), 8);
  auto reading = read();
  const auto idle = kj::mv(stream_);
  const auto idlePeer = kj::mv(peer_);
  // Time goes on until a later one, which has said nothing, has met that deadline.
  open({.partialMilliseconds = 1, .firstMilliseconds = 1});
  EXPECT_EQ(nextFault(), kSilent);
  EXPECT_FALSE(reading.poll(port_.scope()));
}

TEST_F(MessageStreamTest, ATruncatedMessageIsAnError) {
  open();
  const auto frame = blobFrame(800);
  sendAll(peer_, std::span(frame).first(frame.size() - 8));
  peer_ = nullptr;
  EXPECT_EQ(nextFault(), "the peer closed in the middle of a message");
}

TEST_F(MessageStreamTest, AnOrderlyCloseIsTheEnd) {
  open();
  sendAll(peer_, blobFrame(8));
  peer_ = nullptr;
  EXPECT_EQ(nextBlob(), 8);
  EXPECT_EQ(nextBlob(), -1);
}

TEST_F(MessageStreamTest, ACloseWhileWaitingIsTheEnd) {
  open();
  auto reading = bounded(read());
  EXPECT_FALSE(reading.poll(port_.scope()));
  peer_ = nullptr;
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
}

TEST_F(MessageStreamTest, ManyMessagesInOneSegment) {
  open();
  std::vector<std::byte> bytes;
  for (std::size_t i = 1; i <= 100; ++i) {
    const auto frame = blobFrame(i);
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  sendAll(peer_, bytes);
  for (std::int64_t i = 1; i <= 100; ++i) EXPECT_EQ(nextBlob(), i);
}

TEST_F(MessageStreamTest, OneByteAtATime) {
  open();
  const auto frame = blobFrame(100);
  auto reading = bounded(read());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    EXPECT_FALSE(reading.poll(port_.scope())) << i;
    sendAll(peer_, std::span(frame).subspan(i, 1));
  }
  EXPECT_TRUE(reading.wait(port_.scope()) != nullptr);
}

TEST_F(MessageStreamTest, ALargeMessageArrivesWhole) {
  open();
  auto pair = makeSocketPair();
  MessageStream sender(port_, kj::mv(pair.ours));
  stream_ = kj::heap<MessageStream>(port_, kj::mv(pair.theirs));
  capnp::MallocMessageBuilder message;
  auto blob = message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(1 << 20);
  for (std::size_t i = 0; i < blob.size(); ++i) blob[i] = static_cast<capnp::byte>(i * 31);
  sender.write(message.getSegmentsForOutput());
  auto received = bounded(read()).wait(port_.scope());
  KJ_IF_MAYBE (reader, received) {
    const auto root = (*reader)->getBody().getAs<capnp::Data>();
    EXPECT_TRUE(root == blob.asReader());
  } else {
    FAIL() << "the stream ended";
  }
  EXPECT_EQ(sender.counters()->sentBytes, stream_->counters()->receivedBytes);
}

// This holds wherever one receive ends: in a header, in a long message, or behind it.
TEST_F(MessageStreamTest, ShortMessagesArriveAroundALongOne) {
  for (const std::size_t piece : {7, 4'099, 65'537, 1'000'000}) {
    open();
    std::vector<std::byte> bytes;
    for (const std::size_t size : {8, 200'000, 16, 70'000, 65'000, 24}) {
      const auto frame = blobFrame(size);
      bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    TestThread sender([&] {
      for (std::span<const std::byte> rest(bytes); !rest.empty();) {
        const auto now = rest.first(std::min(piece, rest.size()));
        sendAll(peer_, now);
        rest = rest.subspan(now.size());
      }
    });
    for (const int size : {8, 200'000, 16, 70'000, 65'000, 24}) EXPECT_EQ(nextBlob(), size);
  }
}

TEST_F(MessageStreamTest, ALongMessageTakesNoEarlyMemory) {
  constexpr std::uint32_t kWords = (15u << 20) / sizeof(capnp::word);
  std::vector<kj::AutoCloseFd> peers;
  std::vector<kj::Own<MessageStream>> streams;
  std::vector<MessageStream::Reading> reads;
  const std::size_t before = residentBytes();
  for (int i = 0; i < 8; ++i) {
    open();
    const std::uint32_t words[4] = {0, kWords, 0, 0};
    sendAll(peer_, std::as_bytes(std::span(words)));
    reads.push_back(read());
    EXPECT_FALSE(reads.back().poll(port_.scope()));
    peers.push_back(kj::mv(peer_));
    streams.push_back(kj::mv(stream_));
  }
  EXPECT_LT(residentBytes(), before + (8u << 20));
}

TEST_F(MessageStreamTest, AMessagesPartsCountForTheBound) {
  openBounded(100'000);
  auto reading = read();  // it waits: from here on each read knows that the peer has not closed
  EXPECT_FALSE(reading.poll(port_.scope()));
  sendAll(peer_, blobFrame(8));
  EXPECT_TRUE(reading.poll(port_.scope()));
  const auto frame = blobFrame(200'000);
  sendAll(peer_, std::span(frame).first(120'000));
  const std::string fault = nextFault();
  EXPECT_NE(fault.find("the unfinished messages of the peer would need more than 100000 bytes"),
            std::string::npos)
      << fault;
}

TEST_F(MessageStreamTest, AWholeMessageCountsNoMore) {
  openBounded(100'000);
  sendAll(peer_, blobFrame(90'000));
  EXPECT_EQ(nextBlob(), 90'000);
  PeerBudget::Share ofAnotherLink(budget_, "the peer");
  EXPECT_FALSE(ofAnotherLink.hold(90'000));
}

TEST_F(MessageStreamTest, MessagesOfOneTurnLeaveTogether) {
  open();
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(16);
  for (int i = 0; i < 3; ++i) stream_->write(message.getSegmentsForOutput());
  port_.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port_.scope());
  std::byte bytes[1024];
  const auto frame = blobFrame(16).size();
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), static_cast<ssize_t>(3 * frame));
  EXPECT_EQ(stream_->counters()->sentBytes, 3 * frame);
}

TEST_F(MessageStreamTest, ADelayableMessageLeavesSoon) {
  open();
  capnp::MallocMessageBuilder waits, doesNot;
  waits.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(8);
  doesNot.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(16);
  const auto arrived = [this] {
    std::byte bytes[1024];
    return recv(peer_, bytes, sizeof(bytes), 0);
  };
  const auto pass = [this](int milliseconds) {
    port_.getTimer().afterDelay(milliseconds * kj::MILLISECONDS).wait(port_.scope());
  };
  stream_->write(waits.getSegmentsForOutput(), MessageStream::Leaves::WithNextMessage);
  kj::evalLast([] {}).wait(port_.scope());
  EXPECT_EQ(arrived(), -1);
  stream_->write(doesNot.getSegmentsForOutput());
  kj::evalLast([] {}).wait(port_.scope());
  pass(0);
  EXPECT_EQ(arrived(), static_cast<ssize_t>(blobFrame(8).size() + blobFrame(16).size()));
  stream_->write(waits.getSegmentsForOutput(), MessageStream::Leaves::WithNextMessage);
  kj::evalLast([] {}).wait(port_.scope());
  ssize_t alone = -1;
  for (const Time deadline = now() + kPatience; alone == -1 && now() < deadline;) {
    pass(1);
    alone = arrived();
  }
  EXPECT_EQ(alone, static_cast<ssize_t>(blobFrame(8).size()));
}

TEST_F(MessageStreamTest, CountsReceivedBytes) {
  open();
  sendAll(peer_, blobFrame(100));
  EXPECT_EQ(nextBlob(), 100);
  EXPECT_EQ(stream_->counters()->receivedBytes, blobFrame(100).size());
}

TEST_F(MessageStreamTest, AnEarlyCloseEndsBothDirections) {
  open();
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(2 << 20);
  stream_->write(message.getSegmentsForOutput());
  auto ending = stream_->end();
  EXPECT_FALSE(ending.poll(port_.scope()));
  peer_ = nullptr;
  EXPECT_THROW(bounded(kj::mv(ending)).wait(port_.scope()), kj::Exception);
  stream_->write(message.getSegmentsForOutput());
  EXPECT_THROW(stream_->end().wait(port_.scope()), kj::Exception);
  EXPECT_NE(nextFault(), "a message");
}

TEST_F(MessageStreamTest, AStuckPeersCostIsBounded) {
  open({.unsentBytes = 3u << 20});
  auto reading = bounded(read());
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(1 << 20);
  for (int i = 0; i < 3; ++i) stream_->write(message.getSegmentsForOutput());
  EXPECT_FALSE(reading.poll(port_.scope()));  // the third fits beside what the socket has taken
  for (int i = 0; i < 2; ++i) stream_->write(message.getSegmentsForOutput());
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
  try {
    stream_->end().wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), "the peer does not take what is sent");
  }
}

TEST_F(MessageStreamTest, AStuckStrangersCostIsBounded) {
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(15 << 10);
  for (const bool becomesKnown : {false, true}) {
    const auto known = std::make_shared<bool>(false);
    open({}, {.known = known, .share = nullptr});
    auto reading = bounded(read());
    stream_->write(message.getSegmentsForOutput());
    EXPECT_FALSE(reading.poll(port_.scope()));
    *known = becomesKnown;
    for (int i = 0; i < 2; ++i) stream_->write(message.getSegmentsForOutput());
    EXPECT_EQ(reading.poll(port_.scope()), !becomesKnown);
  }
}

// A peer that says it is done keeps its link open until all is sent, so it could keep it for ever.
TEST_F(MessageStreamTest, AStuckPeerDelaysNoEnd) {
  open({.drainMilliseconds = 20});
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(2 << 20);
  stream_->write(message.getSegmentsForOutput());
  try {
    bounded(stream_->end()).wait(port_.scope());
    FAIL() << "no failure";
  } catch (const kj::Exception& e) {
    EXPECT_EQ(loop::describe(e), "the peer does not take what is sent");
  }
}

// The stream needs a descriptor to learn when a full socket takes bytes again.
TEST_F(MessageStreamTest, AFullSocketEndsNothingElse) {
#if defined(SUTURE_ADDRESS_SANITIZER)
  GTEST_SKIP() << "UBSan itself takes a descriptor to look at an object";
#endif
  auto pair = makeSocketPair();
  fill(pair.ours);
  MessageStream stream(port_, kj::mv(pair.ours));
  auto reading = bounded(stream.read());
  EXPECT_FALSE(reading.poll(port_.scope()));
  const NoMoreDescriptors limit;
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(8);
  stream.write(message.getSegmentsForOutput());
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
  const std::string failure = refusal([&] { stream.end().wait(port_.scope()); });
  EXPECT_TRUE(contains(failure, "Too many open files")) << failure;
}

TEST_F(MessageStreamTest, APeerThatStopsReadingIsGone) {
  open();
  auto reading = bounded(read());
  shutdown(peer_, SHUT_RD);
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(8);
  stream_->write(message.getSegmentsForOutput());
  EXPECT_TRUE(reading.wait(port_.scope()) == nullptr);
}

TEST_F(MessageStreamTest, EndSendsWhatIsPendingThenCloses) {
  open();
  capnp::MallocMessageBuilder message;
  message.getRoot<capnp::AnyPointer>().initAs<capnp::Data>(16);
  stream_->write(message.getSegmentsForOutput());
  bounded(stream_->end()).wait(port_.scope());
  std::byte bytes[1024];
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), static_cast<ssize_t>(blobFrame(16).size()));
  EXPECT_EQ(recv(peer_, bytes, sizeof(bytes), 0), 0);
}

}  // namespace
}  // namespace suture::framing
