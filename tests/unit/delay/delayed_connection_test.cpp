#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <suture/observe/merge.h>
#include <suture/observe/observe.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "reference/arm_like.suture.h"
#include "support/eventually.h"
#include "support/patience.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::JointState;
using reference::Mode;
using reference::PoseStamped;

/// Writes down when it was told what.
class Arm final : public PeriodicTask, public ArmLike {
 public:
  Arm() : PeriodicTask({.period = 1ms}) {}

  void servo_cp(const PoseStamped& goal) override {
    pose_ = goal;
    ++servos;
  }
  void servo_jp(const JointState&) override {}
  void hold() override {
    heldAt = now();
    ++holds;
  }
  void set_mode(Mode mode) override {
    emittedAt = now();
    arm_.emit().mode(mode);
  }
  PoseStamped measured_cp() const override { return pose_; }
  const JointState& measured_js() const override { return joints_; }
  double distance(const PoseStamped& to) const override { return to.pose.translation().x(); }
  bool move(const PoseStamped&, double, const std::string&) override { return false; }
  std::uint32_t reset() override { return 0; }
  void limit(double speed, Mode) override {
    if (speed < 0) throw std::runtime_error("the drive did not answer");
    const std::lock_guard lock(mutex_);
    limits_.push_back(speed);
  }
  std::vector<double> limits() const {
    const std::lock_guard lock(mutex_);
    return limits_;
  }

  std::atomic<Time> heldAt{Time{}}, emittedAt{Time{}};
  std::atomic<int> holds{0}, servos{0};

 private:
  void run() override {}

  PoseStamped pose_;
  JointState joints_;
  mutable std::mutex mutex_;
  std::vector<double> limits_;
  Provided<ArmLike> arm_{*this, "Arm", *this};
};

struct Client final : Device {
  Client() {
    arm.on().mode([this](const Mode&) { heardAt = now(); });
  }
  Required<ArmLike> arm{*this, "Arm"};
  Time heardAt{};
};

/// Holds an arm, and clients that are connected to it as each test says.
struct Delayed : testing::Test {
  Delayed() {
    manager.add("PSM", arm);
    manager.add("A", a);
    manager.add("B", b);
    manager.start();
  }
  ~Delayed() override { manager.stop(); }
  void connect(const char* client, const ConnectionDelay& delay) {
    manager.connect(std::string(client) + "/Arm", "PSM/Arm", {.patience = 1s, .delay = delay});
  }

  Arm arm;
  Client a, b;
  Manager manager{"here"};
};

TEST_F(Delayed, ACommandArrivesAfterItsDelay) {
  connect("A", {.commands = 50ms});
  const Time sent = now();
  EXPECT_TRUE(a.arm.hold());
  EXPECT_TRUE(eventually([&] { return arm.holds == 1; }));
  EXPECT_GE(arm.heldAt.load() - sent, 50ms);
}

TEST_F(Delayed, AnAnswerArrivesAfterItsDelay) {
  connect("A", {.answers = 50ms});
  const auto answer = a.arm.hold.start().within(kPatience);
  const Time heard = now();
  EXPECT_TRUE(answer);
  EXPECT_GE(heard - arm.heldAt.load(), 50ms);
}

TEST_F(Delayed, BothWaysAddUp) {
  connect("A", {.commands = 20ms, .answers = 30ms});
  const Time sent = now();
  PoseStamped pose;
  pose.pose.translation().x() = 7;
  const auto distance = a.arm.distance.start(pose).within(kPatience);
  EXPECT_GE(now() - sent, 50ms);
  ASSERT_TRUE(distance);
  EXPECT_EQ(*distance, 7);
}

TEST_F(Delayed, AnEventArrivesAfterItsDelay) {
  connect("A", {.answers = 50ms});
  EXPECT_TRUE(a.arm.set_mode(Mode::Enabled));
  const Time deadline = now() + kPatience;
  while (a.heardAt == Time{} && now() < deadline) a.waitForEvents(deadline);
  ASSERT_NE(a.heardAt, Time{});
  EXPECT_GE(a.heardAt - arm.emittedAt.load(), 50ms);
}

TEST_F(Delayed, ADelayAgesARead) {
  connect("A", {.answers = 40ms});
  EXPECT_TRUE(eventually([&] { return a.arm.measured_cp().hasValue(); }));
  for (int i = 0; i < 20; ++i) {
    const auto pose = a.arm.measured_cp();
    ASSERT_TRUE(pose);
    EXPECT_GE(pose.age(), 40ms);
  }
  // The past is there as well, row by row.
  const auto newest = a.arm.measured_cp();
  EXPECT_TRUE(eventually([&] { return a.arm.measured_cp().stamp() > newest.stamp() + 20ms; }));
  EXPECT_EQ(a.arm.measured_cp.at(newest.stamp()).stamp(), newest.stamp());
}

TEST_F(Delayed, ATtlSeesTheDelay) {
  connect("A", {.commands = 600ms});
  EXPECT_TRUE(a.arm.servo_cp(PoseStamped{}));  // ttl 500 ms
  const auto channels = manager.channels();
  ASSERT_EQ(channels.size(), 2u);  // the client's end and the provider's
  EXPECT_TRUE(eventually([&] { return channels[1]->commands.counters.late == 1; }));
  EXPECT_EQ(arm.servos, 0);
}

TEST_F(Delayed, CommandsRunInTheirOrder) {
  connect("A", {.commands = 3ms, .answers = 3ms});
  std::vector<double> sent;
  const Time deadline = now() + kPatience;
  while (sent.size() < 500 && now() < deadline) {
    const auto number = static_cast<double>(sent.size());
    if (a.arm.limit(number, Mode::Enabled)) {
      sent.push_back(number);
    } else {
      pass(100us);
    }
  }
  EXPECT_TRUE(eventually([&] { return arm.limits().size() == sent.size(); }));
  EXPECT_EQ(arm.limits(), sent);
}

TEST_F(Delayed, TheDepthBoundsCommandsUnderWay) {
  connect("A", {.commands = 30s});
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(a.arm.hold());  // queue(4)
  EXPECT_EQ(a.arm.hold().error(), Errc::Full);
  pass(20ms);  // also once they have left the mailbox
  EXPECT_EQ(a.arm.hold().error(), Errc::Full);
  for (int i = 0; i < 10'000; ++i) EXPECT_TRUE(a.arm.servo_cp(PoseStamped{}));
  EXPECT_EQ(arm.holds, 0);
}

TEST_F(Delayed, ASlowConnectionDelaysNoOther) {
  connect("A", {.commands = 60s, .answers = 60s});
  connect("B", {.commands = 1ms, .answers = 1ms});
  auto slow = a.arm.hold.start();
  EXPECT_TRUE(b.arm.hold.start().within(kPatience));
  EXPECT_TRUE(eventually([&] { return b.arm.measured_cp().hasValue(); }));
  EXPECT_FALSE(slow.poll());
  EXPECT_EQ(a.arm.measured_cp().error(), Errc::NotYet);
}

TEST_F(Delayed, ALossArrivesAfterEarlierAnswers) {
  connect("A", {.answers = 2s});
  auto call = a.arm.hold.start();
  EXPECT_TRUE(eventually([&] { return arm.holds == 1; }));
  arm.stop();
  EXPECT_TRUE(a.arm.connected());  // it cannot know yet
  EXPECT_TRUE(call.within(kPatience));
  EXPECT_TRUE(eventually([&] { return a.arm.unusable() == Errc::Lost; }));
}

TEST_F(Delayed, BothEndsOfAConnectionAreReported) {
  connect("A", {.commands = 1ms, .answers = 1ms});
  EXPECT_TRUE(a.arm.hold.start().within(kPatience));
  const Report report = observe(manager, now());
  ASSERT_EQ(report.connections.size(), 2u);
  EXPECT_EQ(report.connections[0].end, ConnectionEnd::Client);
  EXPECT_EQ(report.connections[0].lane, "local+delay");
  EXPECT_EQ(report.connections[1].end, ConnectionEnd::Provider);
  const auto merged = mergeConnections({report});
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged[0].sent, 1u);
  EXPECT_EQ(merged[0].executed, 1u);
  EXPECT_GE(merged[0].commandAge.max, 1ms);
}

// The answer gives a call's place back, and either the call or the answer may be lost.
TEST_F(Delayed, EveryCallEndsThoughMessagesAreLost) {
  connect("A", {.faults = {.seed = 1, .loss = 0.5}});
  int ended = 0, lost = 0;
  for (int i = 0; i < 16; ++i) {
    auto call = a.arm.distance.start(PoseStamped{});
    ASSERT_TRUE(eventually([&] { return call.poll() != nullptr; })) << i;
    ++ended;
    if (*call.poll()) continue;
    EXPECT_EQ(call.poll()->error(), Errc::OutcomeUnknown);
    ++lost;
  }
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, ended);
}

TEST_F(Delayed, AbandonedCallsFreeTheirPlacesDespiteLosses) {
  connect("A", {.faults = {.seed = 2, .loss = 0.5}});
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(eventually([&] {
      return a.arm.distance.start(PoseStamped{}).within(0ms).error() == Errc::Timeout;
    })) << i;
  }
}

TEST_F(Delayed, EveryCreditComesBackDespiteLosses) {
  connect("A", {.faults = {.seed = 3, .loss = 0.5}});
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(eventually([&] { return a.arm.hold().has_value(); })) << i;
  }
  EXPECT_GT(arm.holds, 0);
  EXPECT_LT(arm.holds, 100);
  EXPECT_GT(observe(manager, now()).connections.at(0).messagesLost, 0u);
}

TEST_F(Delayed, WithoutDelayTheConnectionIsLocal) {
  connect("A", {});
  EXPECT_EQ(manager.channels().at(0)->lane, "local");
}

// The provider runs again before the thread that delays has looked.
TEST_F(Delayed, ARestartAwaitsTheOperator) {
  arm.restartAfterFaults({.most = 1, .per = 24h});
  manager.connect(
      "A/Arm", "PSM/Arm",
      {.patience = 1s, .delay = {.commands = 1ms}, .contract = {.resume = Resume::Operator}});
  EXPECT_TRUE(a.arm.limit(-1, Mode::Enabled));
  EXPECT_TRUE(eventually([&] { return arm.faults() == 1; }));
  EXPECT_TRUE(eventually([&] { return a.arm.hold().error() == Errc::AwaitingOperator; }));
  EXPECT_EQ(arm.state(), ComponentState::Running);
}

}  // namespace
}  // namespace suture
