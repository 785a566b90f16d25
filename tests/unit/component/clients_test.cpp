// A provider's component learns of its clients: that they came, that they are gone, and whose
// command it executes.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/task.h>
#include <suture/wiring/connect.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using Lines = std::vector<std::string>;

/// Writes down what it is told in its cycles, which the test runs.
struct HostingArm final : Task, StillArm {
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;

  void run() override { idle = caller() == nullptr; }
  void hold() override {
    lines.push_back("hold of " + std::string(caller()->name));
    if (throwing) throw std::runtime_error("the brake is stuck");
  }
  void onClient(const ProvidedBase& interface, const ConnectedClient& client,
                ClientNews news) override {
    static constexpr const char* kNews[] = {"connected", "closed", "silent"};
    lines.push_back(interface.name() + ": " + std::string(client.name) + " " +
                    kNews[static_cast<int>(news)]);
    if (throwing) throw std::runtime_error("who is that?");
  }
  Lines taken() { return std::exchange(lines, {}); }

  Provided<reference::ArmLike> arm{*this, "Arm", *this};
  Lines lines;
  bool idle = false, throwing = false;
};

class Clients : public testing::Test {
 protected:
  Clients() { arm_.start(); }
  ~Clients() override { arm_.stop(); }

  std::shared_ptr<Channel> connect(ArmClient& client, const std::string& process = "console") {
    return connectLocally(client.arm, arm_.arm, process + ":Teleop/Slave -> robot:PSM/Arm");
  }
  Lines inTheNextCycle() {
    arm_.cycle();
    return arm_.taken();
  }

  HostingArm arm_;
  std::unique_ptr<ArmClient> client_ = std::make_unique<ArmClient>();
};

TEST_F(Clients, AreToldOfBeforeTheirCommands) {
  connect(*client_);
  ASSERT_TRUE(client_->arm.hold());
  EXPECT_EQ(inTheNextCycle(),
            (Lines{"Arm: console:Teleop/Slave connected", "hold of console:Teleop/Slave"}));
  ASSERT_TRUE(client_->arm.hold());
  EXPECT_EQ(inTheNextCycle(), Lines{"hold of console:Teleop/Slave"});
}

TEST_F(Clients, AGoneClientIsToldOfOnce) {
  ArmClient other;
  connect(*client_);
  connect(other, "gui");
  inTheNextCycle();
  client_.reset();
  EXPECT_EQ(inTheNextCycle(), Lines{"Arm: console:Teleop/Slave closed"});
  EXPECT_EQ(inTheNextCycle(), Lines{});
}

TEST_F(Clients, AClosedSilentClientIsToldOnce) {
  const std::shared_ptr<Channel> channel = connect(*client_);
  inTheNextCycle();
  channel->tell(ChannelStatus::Lapsed);
  EXPECT_EQ(inTheNextCycle(), Lines{"Arm: console:Teleop/Slave silent"});
  EXPECT_EQ(inTheNextCycle(), Lines{});
  client_.reset();
  EXPECT_EQ(inTheNextCycle(), Lines{});
}

TEST_F(Clients, AReconnectedClientIsAnother) {
  connect(*client_);
  inTheNextCycle();
  client_->arm.attach(nullptr);
  client_->arm.adopt();
  connect(*client_);
  const Lines lines = inTheNextCycle();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0], lines[1]) << "one has gone, one has come";
}

TEST_F(Clients, ABriefClientIsNotToldOf) {
  connect(*client_);
  client_.reset();
  EXPECT_EQ(inTheNextCycle(), Lines{});
}

TEST_F(Clients, AGoneClientIsToldOfFirst) {
  ArmClient other;
  connect(other, "gui");
  connect(*client_);
  inTheNextCycle();
  ASSERT_TRUE(other.arm.hold());
  client_.reset();
  EXPECT_EQ(inTheNextCycle(),
            (Lines{"Arm: console:Teleop/Slave closed", "hold of gui:Teleop/Slave"}));
}

TEST_F(Clients, ASuspendedComponentHearsOfThemLater) {
  connect(*client_);
  inTheNextCycle();
  arm_.request(Transition::Suspend);
  inTheNextCycle();
  client_.reset();
  EXPECT_EQ(inTheNextCycle(), Lines{});
  arm_.request(Transition::Resume);
  inTheNextCycle();
  EXPECT_EQ(inTheNextCycle(), Lines{"Arm: console:Teleop/Slave closed"});
}

TEST_F(Clients, AreNotNamedOutsideOfTheirCommands) {
  connect(*client_);
  inTheNextCycle();
  ASSERT_TRUE(client_->arm.hold());
  inTheNextCycle();
  EXPECT_TRUE(arm_.idle);
  arm_.throwing = true;
  ASSERT_TRUE(client_->arm.hold());
  inTheNextCycle();
  ASSERT_EQ(arm_.state(), ComponentState::Faulted);
}

TEST_F(Clients, AHookThatThrowsParksTheComponent) {
  arm_.throwing = true;
  connect(*client_);
  EXPECT_EQ(inTheNextCycle(), Lines{"Arm: console:Teleop/Slave connected"});
  EXPECT_EQ(arm_.state(), ComponentState::Faulted);
  EXPECT_EQ(arm_.fault(), "who is that?");
}

}  // namespace
}  // namespace suture
