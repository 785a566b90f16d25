// Frames that are whole and undamaged may say what they like: a channel is all that they reach.
#include <gtest/gtest.h>
#include <suture/lane/frame/frame_link.h>

#include <array>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "reference/played_channel.h"
#include "support/socket_pair.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr std::uint32_t kHostileEpoch = 9, kConnection = 4;
constexpr unsigned kSessions = 2000;

const InterfaceInfo& contract() { return interfaceInfo<reference::ArmLike>(); }

/// This is a channel in which the test plays everything.
struct Played {
  std::shared_ptr<Channel> channel = reference::armChannel(reference::playedEnds(), "frame");
};

/// This is a peer that knows the form of frames.
class Peer {
 public:
  explicit Peer(kj::AutoCloseFd socket) : socket_(kj::mv(socket)) {}

  void send(const Header& header, std::span<const std::byte> payload) {
    std::byte* const memory = writer_.begin(header, payload.size());
    std::copy(payload.begin(), payload.end(), memory);
    writer_.finish();
    sendAll(socket_, writer_.unsent());
    writer_.sent(writer_.unsent().size());
  }
  void drain() {
    std::array<std::byte, 4096> bytes;
    while (recv(socket_, bytes.data(), bytes.size(), 0) > 0) continue;
  }

 private:
  kj::AutoCloseFd socket_;
  FrameWriter writer_{kHostileEpoch};
};

/// Writes headers as a peer does, then changes a number or two at random.
class Liar {
 public:
  Liar(unsigned seed, Form form) : random_(seed), form_(form) {}

  template <std::size_t N>
  Header header(const std::array<Kind, N>& kinds) {
    Header header{.acknowledged = any(200) == 0 ? word() : 0,
                  .kind = any(100) == 0 ? static_cast<Kind>(any(kKinds)) : kinds[any(N)],
                  .error = static_cast<std::uint8_t>(any(3) == 0 ? any(256) : 0),
                  .number = static_cast<std::uint16_t>(any(100) == 0 ? any(65536) : any(8)),
                  .call = any(3) == 0 ? word() : any(20),
                  .connection = any(50) == 0 ? word() : kConnection};
    header.stamp = any(2) == 0 ? toNanoseconds(now()) : static_cast<std::int64_t>(word()) << 32;
    return header;
  }
  /// Returns a payload that is often of the right size, so that more than the first check is
  /// reached.
  std::span<const std::byte> payload(const Header& header) {
    if (form_ == Form::Encoded && any(4) != 0 && isValue(header)) return damagedMessage(header);
    std::size_t size = any(300);
    const std::size_t number = header.number;
    if (any(50) != 0 && number < contract().commands.size()) {
      const CommandInfo& command = contract().commands[number];
      if (header.kind == Kind::Command) size = command.argumentsSize;
      if (header.kind == Kind::Reply) size = header.error == 0 ? command.resultSize : 0;
    }
    if (header.kind == Kind::Event && any(50) != 0 && number < contract().events.size()) {
      size = contract().events[number].payloadSize;
    }
    if (header.kind == Kind::Subscribe && any(50) != 0) size = sizeof(Subscription);
    bytes_.resize(size);
    for (std::byte& byte : bytes_) byte = static_cast<std::byte>(any(3) == 0 ? random_() : 0);
    return bytes_;
  }
  unsigned any(unsigned below) { return static_cast<unsigned>(random_() % below); }

 private:
  std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }

  static bool isValue(const Header& header) {
    const bool event = header.kind == Kind::Event;
    return (event || header.kind == Kind::Command || header.kind == Kind::Reply) &&
           header.number < (event ? contract().events.size() : contract().commands.size());
  }
  /// Returns a right message, or one in which a byte or two are random.
  std::span<const std::byte> damagedMessage(const Header& header) {
    const std::vector<std::uint64_t> zeros(largestSlot(contract()) / 8 + 1);
    const auto right = payloads_->pack({header.kind, header.number},
                                       reinterpret_cast<const std::byte*>(zeros.data()));
    bytes_.assign(right.begin(), right.end());
    for (unsigned hits = any(3); hits > 0 && !bytes_.empty(); --hits) {
      bytes_[any(static_cast<unsigned>(bytes_.size()))] = static_cast<std::byte>(random_());
    }
    return bytes_;
  }

  std::mt19937 random_;
  const Form form_;
  const std::unique_ptr<Payloads> payloads_ = makePayloads(contract(), Form::Encoded);
  std::vector<std::byte> bytes_;
};

/// Does what a provider's thread does: all that it is given must lie within what its header says.
void serve(Channel& channel, unsigned& executed) {
  channel.commands.fixCut();
  while (const rt::CommandRecord* const record = channel.commands.next()) {
    const CommandInfo& command = contract().commands[record->command];
    ASSERT_TRUE(command.admits(record->arguments()));
    ASSERT_LE(record->stamp, now());
    ++executed;
    const std::uint16_t number = record->command;
    const bool usesCredit = !command.latest || record->call != 0;
    if (record->call != 0) channel.provider.replyError(record->call, Errc::Timeout);
    channel.commands.pop();
    if (usesCredit) channel.commands.returnCredit(number);
  }
}

TEST(HostileFrames, AHostileClientReachesOnlyItsChannel) {
  constexpr std::array kKindsOfClients = {Kind::Command, Kind::Subscribe, Kind::Acknowledge};
  unsigned executed = 0, ended = 0;
  for (unsigned seed = 0; seed < kSessions; ++seed) {
    const Form form = seed % 3 == 0 ? Form::Encoded : Form::Slots;
    Played played;
    auto pair = makeSocketPair();
    const auto side = makeSide<ProviderSide>(played.channel, kConnection, form);
    if (seed % 2 == 0) side->setReadOnly();
    FrameLink link(net::ByteStream(kj::mv(pair.ours)), kHostileEpoch);
    link.join(side);
    Peer peer(kj::mv(pair.theirs));
    Liar liar(seed, form);
    for (int step = 0; step < 40 && !side->broken(); ++step) {
      const Header header = liar.header(kKindsOfClients);
      peer.send(header, liar.payload(header));
      link.arrived();
      link.turn();
      if (liar.any(3) == 0) serve(*played.channel, executed);
      peer.drain();
    }
    if (side->broken()) ++ended;
  }
  EXPECT_GT(executed, 100u);
  EXPECT_GT(ended, kSessions / 10);
  std::printf("%u sessions: %u commands executed, %u sessions ended\n", kSessions, executed, ended);
}

TEST(HostileFrames, AHostileProviderReachesOnlyItsChannel) {
  constexpr std::array kKindsOfProviders = {Kind::Reply, Kind::Event, Kind::Row,
                                            Kind::Taken, Kind::Tally, Kind::Acknowledge};
  unsigned events = 0, ended = 0;
  for (unsigned seed = 0; seed < kSessions; ++seed) {
    const Form form = seed % 3 == 0 ? Form::Encoded : Form::Slots;
    Played played;
    auto pair = makeSocketPair();
    const auto side = makeSide<ClientSide>(played.channel, kConnection, form);
    FrameLink link(net::ByteStream(kj::mv(pair.ours)), kHostileEpoch);
    link.join(side);
    Peer peer(kj::mv(pair.theirs));
    Liar liar(seed, form);
    for (int step = 0; step < 40 && !side->broken(); ++step) {
      played.channel->state->ask(liar.any(2));
      const auto command = static_cast<std::uint16_t>(liar.any(3));
      if (played.channel->commands.claim(command, now(), liar.any(20))) {
        played.channel->commands.commit();
      }
      const Header header = liar.header(kKindsOfProviders);
      peer.send(header, liar.payload(header));
      link.arrived();
      link.turn();
      while (const rt::EventRecord* const record = played.channel->events.next()) {
        ASSERT_TRUE(contract().events[record->event].admits(record->payload()));
        ++events;
        played.channel->events.pop();
      }
      while (played.channel->client.nextReply() != nullptr) played.channel->client.popReply();
      peer.drain();
    }
    if (side->broken()) ++ended;
  }
  EXPECT_GT(events, 100u);
  EXPECT_GT(ended, kSessions / 10);
  std::printf("%u sessions: %u events taken, %u sessions ended\n", kSessions, events, ended);
}

/// Lets `side` take one frame, and returns what of its channel was refused.
template <class Side>
std::string refusedOf(const Header& header, std::uint32_t size) {
  Played played;
  auto pair = makeSocketPair();
  const auto side = makeSide<Side>(played.channel, kConnection);
  FrameLink link(net::ByteStream(kj::mv(pair.ours)), kHostileEpoch);
  link.join(side);
  Peer peer(kj::mv(pair.theirs));
  peer.send(header, std::vector(size, std::byte{0xff}));  // no number
  link.arrived();
  link.turn();
  EXPECT_FALSE(side->broken());
  return std::string(played.channel->lastInvalid.read().text());
}

TEST(HostileFrames, AnInvalidValuesPlaceIsTold) {
  constexpr std::uint16_t kServoCp = 0, kArrived = 1;
  EXPECT_EQ(refusedOf<ProviderSide>(
                {.kind = Kind::Command, .number = kServoCp, .connection = kConnection},
                contract().commands[kServoCp].argumentsSize),
            "servo_cp.goal.pose");
  EXPECT_EQ(
      refusedOf<ClientSide>({.kind = Kind::Event, .number = kArrived, .connection = kConnection},
                            contract().events[kArrived].payloadSize),
      "arrived.pose");
}

}  // namespace
}  // namespace suture::frame
