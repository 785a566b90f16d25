// A stream reads whole messages, and ends in time with the reason if its peer sends something else.

#include <gtest/gtest.h>
#include <suture/framing/message_stream.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "stream_and_peer.h"
#include "support/resources.h"
#include "support/test_thread.h"

namespace suture::framing {
namespace {

class MessageStreamTest : public StreamAndPeer {
 protected:
  /// Opens a stream whose peer may have this many bytes in unfinished messages.
  void openBounded(std::size_t bytes) {
    budget_ = std::make_shared<PeerBudget>(PeerBudget::Limits{.peer = bytes, .process = bytes});
    open({}, {.known = nullptr, .share = std::make_unique<PeerBudget::Share>(budget_, "the peer")});
  }

  std::shared_ptr<PeerBudget> budget_;
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

TEST_F(MessageStreamTest, RefusesTheAdvisoryFrame) {
  open();
  sendAll(peer_, std::vector(16, std::byte{0xff}));
  EXPECT_EQ(nextFault(), toString(HeaderFault::TooManySegments));
}

TEST_F(MessageStreamTest, RefusesAPeerThatSendsText) {
  open();
  sendText(peer_, "GET / HTTP/1.1\r\nHost: robot\r\n\r\n");
  EXPECT_EQ(nextFault(), toString(HeaderFault::TooManySegments));
}

TEST_F(MessageStreamTest, RefusesAHugeLengthAtOnce) {
  open();
  const std::uint32_t words[2] = {0, 0xffffffff};
  sendAll(peer_, std::as_bytes(std::span(words)));
  EXPECT_EQ(nextFault(), toString(HeaderFault::TooLong));
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
    EXPECT_TRUE(fault == toString(HeaderFault::TooManySegments) ||
                fault == toString(HeaderFault::TooLong) || fault == kUnfinished)
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
  // A later stream has the same deadline. Once it has ended, the deadline of the first has passed.
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

TEST_F(MessageStreamTest, ManyMessagesArriveInOneSegment) {
  open();
  std::vector<std::byte> bytes;
  for (std::size_t i = 1; i <= 100; ++i) {
    const auto frame = blobFrame(i);
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  sendAll(peer_, bytes);
  for (std::int64_t i = 1; i <= 100; ++i) EXPECT_EQ(nextBlob(), i);
}

TEST_F(MessageStreamTest, AMessageArrivesByteByByte) {
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

// A receive may end anywhere: in a header, in a long message, or behind it.
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

TEST_F(MessageStreamTest, CountsReceivedBytes) {
  open();
  sendAll(peer_, blobFrame(100));
  EXPECT_EQ(nextBlob(), 100);
  EXPECT_EQ(stream_->counters()->receivedBytes, blobFrame(100).size());
}

}  // namespace
}  // namespace suture::framing
