// A component asks which part of a value was refused.

#include <gtest/gtest.h>
#include <suture/component/task/task.h>
#include <suture/wiring/connect.h>

#include <limits>
#include <string>

#include "reference/still_arm.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Its cycles are the test's.
struct JudgedArm final : Task, StillArm {
  JudgedArm() { start(); }
  ~JudgedArm() override { stop(); }
  void start() override { enter(); }
  void stop() override { leave(); }
  using Task::cycle;

  Provided<reference::ArmLike> port{*this, "Arm", *this};

 private:
  void run() override {}
};

class LastInvalidTest : public testing::Test {
 protected:
  LastInvalidTest() { connectLocally(client_.arm, arm_.port, "Client/Arm -> PSM/Arm"); }

  std::string told() { return std::string(client_.arm.lastInvalid().text()); }
  std::string toldByProvider() { return std::string(arm_.port.lastInvalid().text()); }

  JudgedArm arm_;
  ArmClient client_;
};

TEST_F(LastInvalidTest, IsEmptyWhileAllIsWell) {
  EXPECT_TRUE(client_.arm.limit(1, reference::Mode::Enabled));
  arm_.cycle();
  EXPECT_EQ(told(), "");
  EXPECT_EQ(toldByProvider(), "");
  EXPECT_EQ(ArmClient().arm.lastInvalid().text(), "") << "without a connection as well";
}

TEST_F(LastInvalidTest, NamesTheArgumentThatWasRefusedLast) {
  EXPECT_EQ(client_.arm.limit(kNotANumber, reference::Mode::Enabled).error(), Errc::Invalid);
  EXPECT_EQ(told(), "limit.speed");
  EXPECT_EQ(client_.arm.set_mode(static_cast<reference::Mode>(77)).error(), Errc::Invalid);
  EXPECT_EQ(told(), "set_mode.mode");
  EXPECT_TRUE(client_.arm.limit(1, reference::Mode::Enabled));
  EXPECT_EQ(told(), "set_mode.mode") << "what is admitted leaves it as it is";
  EXPECT_EQ(toldByProvider(), "") << "it never saw them";
}

TEST_F(LastInvalidTest, NamesWhatAnEmitterOffered) {
  EXPECT_TRUE(client_.arm.connected());
  arm_.cycle();
  reference::PoseStamped nowhere;
  nowhere.pose.translation().x() = kNotANumber;
  EXPECT_EQ(arm_.port.emit().arrived(nowhere).error(), Errc::Invalid);
  EXPECT_EQ(toldByProvider(), "arrived.pose");
  EXPECT_EQ(arm_.port.emit().moved({}, kNotANumber).error(), Errc::Invalid);
  EXPECT_EQ(toldByProvider(), "moved.value2") << "of several values by the place of the one";
  EXPECT_EQ(told(), "moved.value2") << "its clients missed it";
}

TEST_F(LastInvalidTest, NamesWhatARowDoesNotHave) {
  EXPECT_EQ(client_.arm.measured_js().error(), Errc::NotYet);
  EXPECT_EQ(client_.arm.measured_cp().error(), Errc::NotYet);
  arm_.joints.position = {0, kNotANumber};
  arm_.cycle();
  EXPECT_TRUE(client_.arm.measured_cp());
  EXPECT_EQ(client_.arm.measured_js().error(), Errc::Invalid);
  EXPECT_EQ(toldByProvider(), "measured_js.position[1]");
  EXPECT_EQ(told(), "measured_js.position[1]");
}

TEST_F(LastInvalidTest, OnlyTheAskerHearsOfIt) {
  ArmClient other;
  connectLocally(other.arm, arm_.port, "Other/Arm -> PSM/Arm");
  arm_.joints.position = {0, kNotANumber};
  auto call = client_.arm.measured_js.fresh();
  arm_.cycle();
  ASSERT_NE(call.poll(), nullptr);
  EXPECT_EQ(call.poll()->error(), Errc::Invalid);
  EXPECT_EQ(told(), "measured_js.position[1]");
  EXPECT_EQ(other.arm.lastInvalid().text(), "");
}

}  // namespace
}  // namespace suture
