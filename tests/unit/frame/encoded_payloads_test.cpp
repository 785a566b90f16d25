// Values between builds that differ: what is malformed has no value, what is not known is refused,
// and nothing is allocated for messages no larger than earlier ones.
#include <gtest/gtest.h>
#include <suture/lane/frame/payloads/encoded_payloads.h>

#include <array>
#include <chrono>
#include <cstring>
#include <vector>

#include "reference/played_channel.h"
#include "support/allocations.h"
#include "unit/frame/joined_links.h"
#include "unit/frame/sides.h"

namespace suture::frame {
namespace {

constexpr std::uint16_t kServoCpCommand = 0, kServoJpCommand = 1, kHoldCommand = 2,
                        kDistanceCommand = 6, kResetCommand = 8;

const InterfaceInfo& armContract() { return interfaceInfo<reference::ArmLike>(); }

/// Packs goals of a number of joints.
class Goals {
 public:
  std::span<const std::byte> pack(std::size_t joints) {
    reference::JointState goal;
    goal.name.assign(joints, "a joint's name!");
    goal.position.assign(joints, 0.5);
    EXPECT_TRUE(store(goal, slot_));
    return payloads_.pack({Kind::Command, kServoJpCommand}, memory());
  }
  std::byte* memory() { return reinterpret_cast<std::byte*>(&slot_); }
  EncodedPayloads& payloads() { return payloads_; }

 private:
  reference::ArmLikeServoJpArguments slot_{};
  EncodedPayloads payloads_{armContract()};
};

TEST(EncodedPayloads, BringWhatWasSent) {
  Goals goals;
  const auto packed = goals.pack(8);
  std::vector<std::byte> bytes(packed.begin(), packed.end());
  EncodedPayloads there(armContract());
  const ArrivedValue value = there.open({Kind::Command, kServoJpCommand}, bytes, Duration{0});
  ASSERT_EQ(value.error, Errc{});
  EXPECT_EQ(std::memcmp(value.slot, goals.memory(),
                        armContract().commands[kServoJpCommand].argumentsSize),
            0);
}

TEST(EncodedPayloads, BringStampsToTheReadersClock) {
  reference::PoseStamped pose;
  pose.stamp = now();
  reference::ArmLikeServoCpArguments slot{};
  ASSERT_TRUE(store(pose, slot));
  EncodedPayloads here(armContract()), there(armContract());
  const ValueName goal{Kind::Command, kServoCpCommand};
  const auto packed = here.pack(goal, reinterpret_cast<const std::byte*>(&slot));
  std::vector<std::byte> bytes(packed.begin(), packed.end());
  const ArrivedValue value = there.open(goal, bytes, std::chrono::seconds(-5));
  ASSERT_EQ(value.error, Errc{});
  const auto& arrived = slotIn<reference::ArmLikeServoCpArguments>(value.slot);
  EXPECT_EQ(slot.goal.stamp - arrived.goal.stamp, 5'000'000'000);
}

TEST(EncodedPayloads, MalformedPayloadsHaveNoValue) {
  EncodedPayloads payloads(armContract());
  std::array<std::byte, 64> bytes;
  bytes.fill(std::byte{0xff});
  const ArrivedValue value = payloads.open({Kind::Command, kServoJpCommand}, bytes, Duration{0});
  EXPECT_NE(value.slot, nullptr);
  EXPECT_EQ(value.error, Errc::Invalid);
  const auto mirror = makeStateTable(armContract(), rt::StateTable::Readers::Here);
  const auto row = payloads.openRow(bytes, Duration{0}, *mirror);
  ASSERT_TRUE(row);
  EXPECT_FALSE(row->columns.any());
}

TEST(EncodedPayloads, MissingValuesAreDefaults) {
  EncodedPayloads payloads(armContract());
  EXPECT_EQ(payloads.open({Kind::Command, kHoldCommand}, {}, Duration{0}).error, Errc{});
  EXPECT_EQ(payloads.open({Kind::Reply, kResetCommand}, {}, Duration{0}).error, Errc{});
  // Every client knows the pose, so a message without it is wrong.
  EXPECT_EQ(payloads.open({Kind::Command, kDistanceCommand}, {}, Duration{0}).error, Errc::Invalid);
}

TEST(EncodedPayloads, AllocateOnlyForALargerOne) {
  Goals goals;
  const auto packed = goals.pack(8);
  std::vector<std::byte> bytes(packed.begin(), packed.end());
  const std::uint64_t before = allocations();
  for (int lap = 0; lap < 100; ++lap) {
    goals.payloads().pack({Kind::Command, kServoJpCommand}, goals.memory());
    goals.payloads().open({Kind::Command, kServoJpCommand}, bytes, Duration{0});
  }
  EXPECT_EQ(allocations(), before);
}

/// Joins a provider to a client that knows a command more, which has another number there.
struct Strangers {
  Strangers() {
    std::vector<std::uint16_t> numbers(armContract().commands.size(), ProviderSide::kUnknown);
    numbers[kResetCommand] = kHoldCommand;
    links.far->join(makeSide<ProviderSide>(far, 1, Form::Encoded, ClientCommands{numbers, {}}));
    links.near->join(makeSide<ClientSide>(near, 1, Form::Encoded));
  }
  static std::shared_ptr<Channel> makeChannel() {
    return reference::armChannel(reference::playedEnds(), "frame");
  }
  bool send(std::uint16_t command, std::uint32_t call) {
    if (!near->commands.claim(command, now(), call)) return false;
    near->commands.commit();
    links.exchange();
    return true;
  }

  const std::shared_ptr<Channel> near = makeChannel(), far = makeChannel();
  JoinedLinks links;
};

TEST(EncodedPayloads, AnUnknownCommandIsRefusedWithoutCredit) {
  Strangers strangers;
  for (unsigned i = 0; i < 2 * armContract().commands[kHoldCommand].depth; ++i) {
    EXPECT_TRUE(strangers.send(kHoldCommand, 0));
  }
  EXPECT_FALSE(strangers.links.near->broken());
  EXPECT_EQ(strangers.far->counts->turnedAway.load(),
            2 * armContract().commands[kHoldCommand].depth);
  ASSERT_TRUE(strangers.send(kHoldCommand, 1));
  const ReplyRecord* const reply = strangers.near->client.nextReply();
  ASSERT_NE(reply, nullptr);
  EXPECT_EQ(reply->error, Errc::NotImplemented);
}

TEST(EncodedPayloads, ACommandWithAnotherNumberArrives) {
  Strangers strangers;
  ASSERT_TRUE(strangers.send(kResetCommand, 0));
  strangers.far->commands.fixCut();
  const rt::CommandRecord* const record = strangers.far->commands.next();
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->command, kHoldCommand);
}

}  // namespace
}  // namespace suture::frame
