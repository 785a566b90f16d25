// These values are larger than a frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/played_channel.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr std::uint32_t kSize = 5 * kMostPayload + 12'345;
enum : std::uint16_t { kDraw, kScan, kPicture };  // commands
enum : std::uint16_t { kScene, kTick };           // events

const InterfaceInfo& easelContract() {
  static const std::vector<CommandInfo> commands{
      {.name = "draw", .kind = CommandKind::Write, .argumentsSize = kSize, .depth = 2},
      {.name = "scan", .kind = CommandKind::QualifiedRead, .resultSize = kSize, .depth = 2},
      {.name = "picture", .kind = CommandKind::Read, .resultSize = kSize, .depth = 2, .column = 0}};
  static const std::vector<EventInfo> events{{.name = "scene", .payloadSize = kSize, .depth = 2},
                                             {.name = "tick", .depth = 8}};
  static const InterfaceInfo info{.name = "Easel",
                                  .hash = "",
                                  .description = "{}",
                                  .commands = commands,
                                  .events = events,
                                  .codec = nullptr};
  return info;
}

std::vector<std::byte> makeValue(unsigned seed) {
  std::vector<std::byte> value(kSize);
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] = static_cast<std::byte>((i * i + seed) / 7);
  }
  return value;
}

bool isValue(unsigned seed, const std::byte* bytes) {
  const auto value = makeValue(seed);
  return std::equal(value.begin(), value.end(), bytes);
}

/// Holds both ends of a connection, whose tasks the test plays.
struct Easel {
  explicit Easel(std::uint32_t number)
      : client(makeSide<ClientSide>(near, number)), provider(makeSide<ProviderSide>(far, number)) {}

  static std::shared_ptr<Channel> makeChannel() {
    return reference::playedChannel(easelContract(), reference::playedEnds(), "frame");
  }
  bool command(std::uint16_t command, std::uint32_t call, unsigned seed) {
    const auto memory = near->commands.claim(command, now(), call);
    if (!memory) return false;
    const auto value = makeValue(seed);
    std::copy_n(value.begin(), easelContract().commands[command].argumentsSize, *memory);
    near->commands.commit();
    return true;
  }
  const rt::CommandRecord* nextCommand() {
    far->commands.fixCut();
    return far->commands.next();
  }

  const std::shared_ptr<Channel> near = makeChannel(), far = makeChannel();
  const std::shared_ptr<ClientSide> client;
  const std::shared_ptr<ProviderSide> provider;
};

class LargeValues : public testing::Test, protected JoinedLinks {
 protected:
  LargeValues() {
    for (Easel* const one : {&easel, &other}) {
      far->join(one->provider);
      near->join(one->client);
    }
    carryAll();
  }
  /// Turns them until nothing is left to send or to take.
  void carryAll() {
    do {
      turn();
    } while (near->hasMore() || far->hasMore() || near->isFull() || far->isFull());
    turn();
  }
  void TearDown() override { EXPECT_FALSE(near->broken() || far->broken()); }

  Easel easel{1}, other{2};
};

TEST_F(LargeValues, CommandsArriveWhole) {
  ASSERT_TRUE(easel.command(kDraw, 0, 1));
  ASSERT_TRUE(easel.command(kDraw, 0, 2));
  carryAll();
  for (const unsigned seed : {1u, 2u}) {
    const rt::CommandRecord* const record = easel.nextCommand();
    ASSERT_NE(record, nullptr);
    EXPECT_TRUE(isValue(seed, record->arguments()));
    easel.far->commands.pop();
    easel.far->commands.returnCredit(kDraw);
  }
  carryAll();
  EXPECT_EQ(easel.near->commands.waiting(kDraw), 0u);
}

TEST_F(LargeValues, AnswersArriveWhole) {
  ASSERT_TRUE(easel.command(kScan, 1, 0));
  carryAll();
  ASSERT_NE(easel.nextCommand(), nullptr);
  const auto fill = [](std::byte* result) {
    const auto value = makeValue(3);
    std::copy(value.begin(), value.end(), result);
    return Errc{};
  };
  easel.far->provider.reply(1, {.size = kSize, .command = kScan}, fill);
  easel.far->commands.pop();
  carryAll();
  const ReplyRecord* const reply = easel.near->client.nextReply();
  ASSERT_NE(reply, nullptr);
  EXPECT_TRUE(isValue(3, reply->result()));
}

TEST_F(LargeValues, EventsArriveWholeAndInOrder) {
  const auto first = makeValue(4), second = makeValue(5);
  ASSERT_TRUE(easel.far->events.push(kScene, now(), first));
  ASSERT_TRUE(easel.far->events.push(kTick, now(), {}));
  ASSERT_TRUE(easel.far->events.push(kScene, now(), second));
  carryAll();
  for (const unsigned seed : {4u, 0u, 5u}) {
    const rt::EventRecord* const event = easel.near->events.next();
    ASSERT_NE(event, nullptr);
    ASSERT_EQ(event->event, seed == 0 ? kTick : kScene);
    EXPECT_TRUE(seed == 0 || isValue(seed, event->payload()));
    easel.near->events.pop();
  }
}

TEST_F(LargeValues, ReadsArriveWhole) {
  easel.near->state->ask(0);
  carryAll();
  for (const unsigned seed : {6u, 7u, 8u}) {
    const auto value = makeValue(seed);
    std::copy(value.begin(), value.end(), easel.far->state->draft(0));
    easel.far->state->publish(now(), {.valid = 1});
    carryAll();
    std::vector<std::byte> slot(kSize);
    std::byte* const slots[] = {slot.data()};
    EXPECT_TRUE(easel.near->state->readRow(slots).hasValue(0));
    EXPECT_TRUE(isValue(seed, slot.data()));
  }
}

// Whatever another connection has goes between the pieces.
TEST_F(LargeValues, LetOthersHaveTheirTurns) {
  ASSERT_TRUE(easel.far->events.push(kScene, now(), makeValue(7)));
  turn();
  int ticks = 0;
  for (; easel.near->events.next() == nullptr; ++ticks) {
    ASSERT_TRUE(other.far->events.push(kTick, now(), {}));
    turn();
    ASSERT_NE(other.near->events.next(), nullptr) << ticks;
    other.near->events.pop();
  }
  EXPECT_GE(ticks, 4);
}

// A connection that ends in the middle of a value leaves the others.
TEST_F(LargeValues, AnEndedConnectionsValuesAreDropped) {
  ASSERT_TRUE(easel.far->events.push(kScene, now(), makeValue(8)));
  turn();
  easel.far->status = ChannelStatus::Closed;
  carryAll();
  ASSERT_TRUE(other.far->events.push(kScene, now(), makeValue(9)));
  carryAll();
  EXPECT_EQ(easel.near->events.next(), nullptr);
  const rt::EventRecord* const event = other.near->events.next();
  ASSERT_NE(event, nullptr);
  EXPECT_TRUE(isValue(9, event->payload()));
}

}  // namespace
}  // namespace suture::frame
