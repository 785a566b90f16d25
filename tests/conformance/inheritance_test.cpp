// A contract that derives from another is used as itself, and as the one it derives from.
#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;

/// The client's interface of the base contract is connected to one of the derived contract.
class Inheritance : public Conformance {
 protected:
  const char* provided() const override { return "Gripper"; }
};

TEST_P(Inheritance, TheBasesCommandsWorkThroughTheBase) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.limit.start(1, Mode::Enabled).within(suture::kPatience));
    const auto moved = remote.move.start(poseAt(5), 1, "far").within(suture::kPatience);
    ASSERT_TRUE(moved) << suture::toString(moved.error());
    const auto pose = remote.measured_cp.fresh().within(suture::kPatience);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->pose.translation().x(), 5);
    EXPECT_EQ(*remote.distance.start(poseAt(7)).within(suture::kPatience), 2);
  });
  EXPECT_EQ(arm->taken(),
            (std::vector<std::string>{"limit 1 enabled", "servo_cp 5", "move 100% far"}));
}

TEST_P(Inheritance, TheBasesEventsArriveThroughTheBase) {
  arm->emitSoon([](Ports ports) {
    EXPECT_TRUE(ports.gripper.emit().mode(Mode::Enabled));
    EXPECT_TRUE(ports.gripper.emit().moved(poseAt(2), 3));
    EXPECT_TRUE(ports.gripper.emit().gripped(1));
  });
  EXPECT_TRUE(client->await([](const Received& received) { return received.moves.size() == 1; }));
}

TEST_P(Inheritance, ReadsArePushedThroughTheBase) {
  client->with([&](Arm& remote) {
    EXPECT_TRUE(remote.servo_cp.start(poseAt(8)).within(suture::kPatience));
  });
  EXPECT_TRUE(suture::eventually([&] {
    double seen = 0;
    client->with([&](Arm& remote) {
      if (const auto pose = remote.measured_cp()) seen = pose->pose.translation().x();
    });
    return seen == 8;
  }));
}

TEST_P(Inheritance, TheDerivedContractHasBoth) {
  connect("Gripper", "Gripper");
  client->withGripper([&](Gripper& remote) {
    EXPECT_TRUE(remote.limit.start(2, Mode::Disabled).within(suture::kPatience));
    const auto closed = remote.close.start(0.04).within(suture::kPatience);
    ASSERT_TRUE(closed) << suture::toString(closed.error());
    EXPECT_EQ(*closed, 0.02);
    EXPECT_EQ(*remote.opening.fresh().within(suture::kPatience), 0.02);
    EXPECT_TRUE(remote.measured_cp.fresh().within(suture::kPatience));
  });
  EXPECT_EQ(arm->taken(), (std::vector<std::string>{"limit 2 disabled", "close"}));
}

TEST_P(Inheritance, TheDerivedContractsOwnEventsArrive) {
  connect("Gripper", "Gripper");
  client->withGripper(
      [](Gripper& remote) { EXPECT_TRUE(remote.opening.fresh().within(suture::kPatience)); });
  arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.gripper.emit().gripped(0.5)); });
  EXPECT_TRUE(client->await(
      [](const Received& received) { return received.grips == std::vector<double>{0.5}; }));
}

TEST_P(Inheritance, TheOtherWayRoundIsRefused) {
  EXPECT_THROW(connect("Gripper", "Arm"), suture::SetupError);
}

INSTANTIATE_TEST_SUITE_P(Lanes, Inheritance, testing::ValuesIn(laneRows()), nameOf);

}  // namespace
}  // namespace conformance
