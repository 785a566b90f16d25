#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/wiring/connect.h>

#include <atomic>
#include <optional>
#include <thread>

#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::JointState;
using reference::Mode;
using reference::PoseStamped;

/// An arm that counts its cycles; Kind is PeriodicTask or EventTask.
template <class Kind>
class CycleCountingArm final : public Kind, public ArmLike {
 public:
  using Kind::Kind;
  ~CycleCountingArm() override { this->stop(); }

  void servo_cp(const PoseStamped& goal) override { pose_ = goal; }
  void servo_jp(const JointState&) override {}
  void hold() override { arm.emit().stopped(); }
  void set_mode(Mode mode) override { arm.emit().mode(mode); }
  PoseStamped measured_cp() const override {
    ++evaluations;
    return pose_;
  }
  const JointState& measured_js() const override { return joints; }
  double distance(const PoseStamped&) const override { return 0; }
  bool move(const PoseStamped&, double, const std::string&) override { return false; }
  std::uint32_t reset() override { return 0; }
  void limit(double, Mode) override {}

  std::atomic<int> cycles{0};
  mutable std::atomic<int> evaluations{0};
  Duration cycleTime{0};
  JointState joints;
  Provided<ArmLike> arm{*this, "Arm", *this};

 private:
  void run() override {
    ++cycles;
    if (cycleTime > Duration{0}) pass(cycleTime);
  }
  PoseStamped pose_;
};

TEST(PeriodicTask, RunsOncePerPeriod) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  const Time begin = now();
  arm.start();
  EXPECT_TRUE(eventually([&] { return arm.cycles >= 50; }));
  arm.stop();
  const auto elapsed = static_cast<double>((now() - begin) / 1ms);
  const TaskStatistics& statistics = arm.statistics();
  const auto accounted = static_cast<double>(statistics.cycles + statistics.skipped);
  EXPECT_LE(accounted, elapsed + 1);
  EXPECT_EQ(statistics.cycles, static_cast<std::uint64_t>(arm.cycles));
}

TEST(PeriodicTask, RefusesAPeriodThatIsNotPositive) {
  EXPECT_EQ(refusal([] { CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 0ms}); }),
            "a periodic task: a period of 0 ns. Give a period greater than zero");
}

TEST(Task, ToldOfSchedulingThatTheKernelRefuses) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.scheduling = {.processor = 4000}});
  try {
    arm.start();
    FAIL() << "there is no processor 4000";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("processor 4000"), std::string::npos) << error.what();
  }
  EXPECT_EQ(arm.cycles, 0);
}

TEST(EventTask, SleepsUntilACommandArrives) {
  CycleCountingArm<EventTask> arm(EventOptions{.longestSleep = 1h});
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  const int before = arm.cycles;
  EXPECT_TRUE(client.arm.hold.start().within(kPatience));
  // There may be a cycle for the first command, whose answer arrives before it counts itself; one
  // for the ring of its answer; one for the second command.
  EXPECT_LE(arm.cycles - before, 3);
}

/// Does nothing until it is told to ask, when it sleeps and has taken all rings.
struct AskingTask : EventTask {
  AskingTask() : EventTask({.longestSleep = 1h}) {}
  void run() final {
    connected = arm.connected();
    if (asks && !answered) work();
  }
  virtual void work() = 0;

  /// Returns true once it has what it asked for.
  bool ask() {
    if (!eventually([&] { return connected.load(); })) return false;
    pass(20ms);
    asks = true;
    doorbell().ring();
    return eventually([&] { return answered.load(); });
  }

  Required<ArmLike> arm{*this, "Arm"};
  std::atomic<bool> connected{false}, asks{false}, answered{false};
};

template <class Client>
bool asks() {
  Client client;
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 5ms});
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  const bool answered = client.ask();
  client.stop();
  return answered;
}

TEST(EventTask, LooksAgainAfterASecondAnswer) {
  struct Impatient final : AskingTask {
    void work() override {
      if (!other) {
        other.emplace(arm.hold.start());
        EXPECT_TRUE(arm.hold.start().within(kPatience));
      } else {
        answered = other->poll() != nullptr;
      }
    }
    std::optional<Call<Result<void>, NoSlot>> other;
  };
  EXPECT_TRUE(asks<Impatient>());
}

TEST(EventTask, LooksAgainAfterASecondEvent) {
  struct Impatient final : AskingTask {
    void work() override {
      if (!mode) {
        mode.emplace(arm.on().mode.next());
        auto stopped = arm.on().stopped.next();
        EXPECT_TRUE(arm.set_mode(Mode::Enabled));
        EXPECT_TRUE(arm.hold());
        EXPECT_TRUE(stopped.within(kPatience));
      } else {
        answered = mode->poll() != nullptr;
      }
    }
    std::optional<decltype(arm.on().mode.next())> mode;
  };
  EXPECT_TRUE(asks<Impatient>());
}

TEST(EventTask, LooksAgainAfterAWaitingHandler) {
  struct Impatient final : AskingTask {
    Impatient() {
      arm.on().mode([this](Mode) { heard = true; });
    }
    void work() override {
      answered = heard;
      if (heard) return;
      auto stopped = arm.on().stopped.next();
      EXPECT_TRUE(arm.set_mode(Mode::Enabled));
      EXPECT_EQ(stopped.within(200ms).error(), Errc::Timeout);
    }
    bool heard = false;
  };
  EXPECT_TRUE(asks<Impatient>());
}

/// Calls once per cycle and has the answer at the end of it.
template <class Ask>
struct Patient final : EventTask {
  explicit Patient(Ask askFor) : EventTask({.longestSleep = 1h}), ask(askFor) {}
  ~Patient() override { stop(); }
  void run() override {
    if (arm.connected() && ask(arm)) ++cycles;
  }
  const Ask ask;
  Required<ArmLike> arm{*this, "Arm"};
  std::atomic<int> cycles{0};
};

template <class Ask>
void expectRest(const Ask& ask) {
  Patient<Ask> client(ask);
  CycleCountingArm<EventTask> arm{EventOptions{}};
  arm.cycleTime = 1ms;  // its answers leave at the beginning of a cycle, their rings at the end
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  client.start();
  EXPECT_TRUE(eventually([&] { return client.cycles > 0; }));
  pass(50ms);
  EXPECT_LT(client.cycles, 6) << "it runs without pause";
}

TEST(EventTask, AnAwaitedAnswerWakesNobody) {
  expectRest([](Required<ArmLike>& arm) { return arm.hold.start().within(kPatience).has_value(); });
}

TEST(EventTask, APolledAnswerWakesNobody) {
  expectRest([](Required<ArmLike>& arm) {
    auto call = arm.hold.start();
    arm.owner().ringNow();
    while (!call.poll()) pass(10us);
    return true;
  });
}

TEST(EventTask, TheFirstAskWakesASleepingProvider) {
  CycleCountingArm<EventTask> arm(EventOptions{.longestSleep = 1h});
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  EXPECT_TRUE(eventually([&] { return client.arm.measured_cp().hasValue(); }));
}

TEST(Provided, EvaluatesOnlyWhatIsAskedFor) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  JointState joints;
  EXPECT_TRUE(eventually([&] { return client.arm.measured_js(joints).hasValue(); }));
  EXPECT_EQ(arm.evaluations, 0);
}

TEST(Provided, ATooLargeReadSaysSo) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  arm.joints.position.assign(9, 0.0);  // capacity(8)
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  JointState joints;
  EXPECT_TRUE(eventually([&] { return client.arm.measured_js(joints).error() == Errc::TooLarge; }));
  EXPECT_EQ(client.arm.measured_js.fresh().within(kPatience).error(), Errc::TooLarge);
}

struct Listener final : Device {
  Listener() {
    arm.on().mode([this](const Mode& mode) { modes.push_back(mode); });
    arm.on().stopped([this] { ++stops; });
  }
  Required<ArmLike> arm{*this, "Arm"};
  std::vector<Mode> modes;
  int stops = 0;
};

TEST(Events, ALateJoinerGetsTheLatchedValue) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  Listener early, late;
  connectLocally(early.arm, arm.arm, "early");
  arm.start();
  EXPECT_TRUE(early.arm.set_mode.start(Mode::Enabled).within(kPatience));
  EXPECT_TRUE(early.arm.hold.start().within(kPatience));
  EXPECT_TRUE(early.waitForEvents(now() + kPatience));
  EXPECT_EQ(early.modes, std::vector<Mode>{Mode::Enabled});
  EXPECT_EQ(early.stops, 1);

  connectLocally(late.arm, arm.arm, "late");
  EXPECT_FALSE(late.arm.connected() && !late.modes.empty());
  EXPECT_TRUE(late.waitForEvents(now() + kPatience));
  EXPECT_EQ(late.modes, std::vector<Mode>{Mode::Enabled});
  EXPECT_EQ(late.stops, 0);
}

TEST(Events, ASlowSubscriberLosesItsOwn) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  Listener quick, slow;
  connectLocally(quick.arm, arm.arm, "quick");
  const auto slowChannel = connectLocally(slow.arm, arm.arm, "slow");
  arm.start();
  constexpr int kEvents = 200;
  for (int i = 1; i <= kEvents; ++i) {
    ASSERT_TRUE(quick.arm.hold.start().within(kPatience));
    while (quick.stops < i) ASSERT_TRUE(quick.waitForEvents(now() + kPatience));
  }
  slow.arm.connected();
  slow.processEvents();
  EXPECT_LT(slow.stops, kEvents);
  EXPECT_EQ(slow.stops + static_cast<int>(slowChannel->events.dropped()), kEvents);
}

TEST(Events, ATaskEmitsInItsOwnThread) {
  CycleCountingArm<EventTask> arm{EventOptions{}};
  Listener listener;
  connectLocally(listener.arm, arm.arm, "test");
  EXPECT_TRUE(arm.arm.emit().mode(Mode::Disabled));  // before it has a thread
  arm.start();
  EXPECT_TRUE(listener.arm.hold.start().within(kPatience));
  EXPECT_EQ(arm.arm.emit().stopped().error(), Errc::WrongThread);
  EXPECT_EQ(arm.arm.emit().mode(Mode::Enabled).error(), Errc::WrongThread);
  EXPECT_TRUE(listener.arm.hold.start().within(kPatience));
  EXPECT_TRUE(eventually([&] {
    listener.processEvents();
    return listener.stops == 2;
  }));
  EXPECT_EQ(listener.modes, std::vector<Mode>{Mode::Disabled});
}

TEST(Events, AHandlerCannotHandleOthers) {
  CycleCountingArm<EventTask> arm{EventOptions{}};
  Listener listener;
  connectLocally(listener.arm, arm.arm, "test");
  int heard = 0;
  Errc answer{};
  bool arrived = true;
  listener.arm.on().stopped([&] {
    if (++heard != 1) return;
    if (const auto handled = listener.processEvents(); !handled) answer = handled.error();
    arrived = listener.waitForEvents(now() + kPatience);
  });
  arm.start();
  ASSERT_TRUE(listener.arm.hold.start().within(kPatience));  // which emits it
  ASSERT_TRUE(listener.arm.hold.start().within(kPatience));
  EXPECT_TRUE(listener.processEvents());
  EXPECT_EQ(answer, Errc::CannotWait);
  EXPECT_FALSE(arrived);
  EXPECT_EQ(heard, 2) << "each of them once";
}

TEST(Device, ALocalClientCallsItDirectly) {
  struct ArmDevice final : Device, ArmLike {
    void servo_cp(const PoseStamped&) override {}
    void servo_jp(const JointState&) override {}
    void hold() override { thread = std::this_thread::get_id(); }
    void set_mode(Mode) override {}
    PoseStamped measured_cp() const override { return {}; }
    const JointState& measured_js() const override { return joints; }
    double distance(const PoseStamped&) const override { return 42; }
    bool move(const PoseStamped&, double, const std::string&) override { return true; }
    std::uint32_t reset() override { return 7; }
    void limit(double, Mode) override {}
    std::thread::id thread;
    JointState joints;
    Provided<ArmLike> arm{*this, "Arm", *this};
  } device;
  ArmClient client;
  connectLocally(client.arm, device.arm, "test");
  EXPECT_TRUE(client.arm.hold());
  EXPECT_EQ(device.thread, std::this_thread::get_id());
  EXPECT_EQ(*client.arm.distance.start(PoseStamped{}).within(0s), 42);
  EXPECT_EQ(*client.arm.reset.start().within(), 7u);
  EXPECT_TRUE(client.arm.measured_cp());
}

TEST(Provided, TwoOfOneContractKeepApart) {
  struct Pair final : PeriodicTask {
    Pair() : PeriodicTask({.period = 1ms}) {}
    ~Pair() override { stop(); }
    void run() override {}
    reference::SimulatedArm first{{}}, second{{}};
    Provided<ArmLike> left{*this, "Left", first};
    Provided<ArmLike> right{*this, "Right", second};
  } pair;
  ArmClient left, right;
  connectLocally(left.arm, pair.left, "left");
  connectLocally(right.arm, pair.right, "right");
  pair.start();
  PoseStamped goal;
  goal.pose.translation().x() = 5;
  EXPECT_TRUE(left.arm.servo_cp.start(goal).within(kPatience));
  EXPECT_EQ(left.arm.measured_cp.fresh().within(kPatience)->pose.translation().x(), 5);
  EXPECT_EQ(right.arm.measured_cp.fresh().within(kPatience)->pose.translation().x(), 0);
}

TEST(Calls, ALackingCommandIsNotImplemented) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1ms});
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  EXPECT_TRUE(client.arm.park.start().within(kPatience));
  // An older provider has such a channel.
  const auto older = std::make_shared<Channel>(
      client.arm.info(),
      Channel::Terms{.name = "test", .lacking = {reference::ArmLikeCommand::park}}, "local",
      Channel::Ends{
          .client = client.sharedDoorbell(), .provider = arm.sharedDoorbell(), .here = &arm.arm},
      arm.arm.state(), EventSet{0});
  arm.arm.attach(older);
  client.arm.attach(older);
  EXPECT_EQ(client.arm.park().error(), Errc::NotImplemented);
  EXPECT_EQ(client.arm.park.start().within(kPatience).error(), Errc::NotImplemented);
  EXPECT_TRUE(client.arm.limit.start(1, Mode::Enabled).within(kPatience));
}

TEST(Calls, TooManyUnderWayAreRefused) {
  CycleCountingArm<PeriodicTask> arm(PeriodicOptions{.period = 1h});  // never gets to answer
  ArmClient client;
  connectLocally(client.arm, arm.arm, "test");
  arm.start();
  std::vector<Call<Result<double>, double>> calls;
  for (unsigned i = 0; i < Channel::kMaxCalls; ++i) {
    calls.push_back(client.arm.distance.start(PoseStamped{}));
    EXPECT_FALSE(calls.back().poll());
  }
  EXPECT_EQ(client.arm.distance.start(PoseStamped{}).within(0s).error(), Errc::TooManyCalls);
}

}  // namespace
}  // namespace suture
