// After a loss no process executes anything of the old connection, whichever process stood still,
// or was cut off from the other while its tasks ran: commands may have waited for longer than the
// client was willing to.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/observe/observe.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"
#include "unit/manager/way.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kSilence = 100ms;

/// Notes which commands it executes, and when.
struct NotingArm final : PeriodicTask, StillArm {
  NotingArm() : PeriodicTask({.period = 1ms}) {}
  ~NotingArm() override { stop(); }
  void run() override {}
  void limit(double number, reference::Mode) override {
    executed.push_back({static_cast<int>(number), now()});
    if (slow) {
      inHandler = true;
      TestClock::spend(length);
      inHandler = false;
    }
  }

  void onClient(const ProvidedBase&, const ConnectedClient& client, ClientNews news) override {
    EXPECT_EQ(client.name, "console:Teleop/Slave");
    EXPECT_EQ(client.silence, kSilence);
    if (news == ClientNews::Connected) ++clients;
    if (news == ClientNews::Closed) ++closed;
    if (news == ClientNews::Silent) ++silent;
    gone = now();
  }

  struct Execution {
    int number;
    Time at;
  };
  std::vector<Execution> executed;
  std::atomic<bool> slow{false}, inHandler{false};
  Duration length = 10ms;                             // how long a slow handler takes
  std::atomic<int> clients{0}, closed{0}, silent{0};  // what it has been told of them
  std::atomic<Time> gone{Time{}};                     // when it was last told anything
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// Sends numbered commands for as long as it is not told that its provider is lost.
struct NumberingClient final : PeriodicTask {
  NumberingClient() : PeriodicTask({.period = 1ms}) {}
  ~NumberingClient() override { stop(); }
  void run() override {
    const bool was = connected.exchange(slave.connected());
    if (was && !connected) {
      told[epoch] = now();
      ++losses;
    }
    if (!was && connected) ++epoch;
    while (connected && !silent && slave.limit(number, reference::Mode::Enabled)) {
      epochOf[number++] = epoch;
      accepted = epoch;
    }
  }

  int number = 1, epoch = 0;
  std::map<int, int> epochOf;
  std::map<int, Time> told;
  std::atomic<bool> connected{false}, silent{false};
  std::atomic<int> losses{0}, accepted{0};  // the latest connection that took a command
  Required<reference::ArmLike> slave{*this, "Slave"};
};

/// Says what stands still. If a network is frozen the other process hears nothing of it, as if a
/// cable was pulled; the tasks of its process run, and on `shm` reach each other.
enum class Frozen {
  Provider,
  Client,
  BothThenProvider,
  BothThenClient,
  ProvidersNetwork,
  ClientsNetwork
};

class FrozenProcess : public testing::TestWithParam<std::tuple<Way, Frozen, bool>> {
 protected:
  FrozenProcess() {
    // A task that goes on comes to what waits behind the first command when the loss is told.
    if (isOneOf({Frozen::ProvidersNetwork, Frozen::ClientsNetwork})) arm_.length = 3 * kSilence / 2;
    providersNetwork_.run(
        [this] { robot_ = std::make_unique<Manager>("robot", names_.address()); });
    provider_.run([this] {
      robot_->add("PSM", arm_);
      robot_->start();
    });
    clientsNetwork_.run(
        [this] { console_ = std::make_unique<Manager>("console", names_.address()); });
    client_.run([this] {
      console_->add("Teleop", teleop_);
      console_->start();
    });
  }
  ~FrozenProcess() noexcept override {
    console_->stop();
    robot_->stop();
  }

  Way way() const { return std::get<Way>(GetParam()); }
  Frozen frozen() const { return std::get<Frozen>(GetParam()); }
  bool inADrain() const { return std::get<bool>(GetParam()); }

  void connect(Resume resume = Resume::Automatic) {
    client_.run([&] {
      console_->connect("Teleop/Slave", "robot:PSM/Arm",
                        way().options({.resume = resume, .silence = kSilence}));
    });
    ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
  }
  bool isOneOf(std::initializer_list<Frozen> cases) const {
    return std::find(cases.begin(), cases.end(), frozen()) != cases.end();
  }
  void freeze() {
    if (!isOneOf({Frozen::Client, Frozen::ClientsNetwork})) {
      providersNetwork_.freeze();
      if (frozen() != Frozen::ProvidersNetwork) provider_.freeze();
    }
    if (!isOneOf({Frozen::Provider, Frozen::ProvidersNetwork})) {
      clientsNetwork_.freeze();
      if (frozen() != Frozen::ClientsNetwork) client_.freeze();
    }
  }
  /// Lets both go on; the later one does so when the other has had time to go wrong.
  void thaw() {
    arm_.slow = false;
    const bool providerFirst = frozen() == Frozen::BothThenProvider;
    providerFirst ? thawProvider() : thawClient();
    pass(20ms);
    providerFirst ? thawClient() : thawProvider();
  }
  void thawProvider() {
    providersNetwork_.thaw();
    provider_.thaw();
  }
  void thawClient() {
    clientsNetwork_.thaw();
    client_.thaw();
  }
  /// Returns the only connection of this process, as it sees it.
  static ConnectionReport ledger(const Manager& manager) {
    const Report report = observe(manager, {});
    return report.connections.empty() ? ConnectionReport{} : report.connections.front();
  }
  int executedAfterLoss() const {
    int count = 0;
    for (const auto& [number, at] : arm_.executed) {
      const auto told = teleop_.told.find(teleop_.epochOf.at(number));
      if (told != teleop_.told.end() && at > told->second) ++count;
    }
    return count;
  }

  const TemporaryDirectory directory_;
  TestClock::Process providersNetwork_{clockOfTest()}, provider_{clockOfTest()},
      clientsNetwork_{clockOfTest()}, client_{clockOfTest()};
  loop::ControlThread control_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  NotingArm arm_;
  NumberingClient teleop_;
  std::unique_ptr<Manager> robot_, console_;
};

std::string nameOf(const testing::TestParamInfo<std::tuple<Way, Frozen, bool>>& info) {
  const char* const who[] = {"Provider",       "Client",           "BothThenProvider",
                             "BothThenClient", "ProvidersNetwork", "ClientsNetwork"};
  return std::string(who[static_cast<int>(std::get<Frozen>(info.param))]) +
         (std::get<bool>(info.param) ? "InADrain" : "") + "_" + std::get<Way>(info.param).name();
}

INSTANTIATE_TEST_SUITE_P(
    Lanes, FrozenProcess,
    testing::Combine(testing::ValuesIn(waysBetweenProcesses()),
                     testing::Values(Frozen::Provider, Frozen::Client, Frozen::BothThenProvider,
                                     Frozen::BothThenClient, Frozen::ProvidersNetwork,
                                     Frozen::ClientsNetwork),
                     testing::Bool()),
    nameOf);

TEST_P(FrozenProcess, ExecutesNothingOfALostConnection) {
  connect();
  for (int round = 0; round < 5; ++round) {
    ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
    EXPECT_EQ(console_->channels().at(0)->lane, way().laneName());
    pass(50ms + round * 3ms);  // what is delayed is at another place in each round
    arm_.slow = inADrain();
    ASSERT_TRUE(eventually([this] { return arm_.inHandler == inADrain(); }));
    freeze();
    pass(2 * kSilence);
    thaw();
    ASSERT_TRUE(eventually([this, round] { return teleop_.losses == round + 1; }));
  }
  ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
  console_->stop();
  robot_->stop();
  EXPECT_EQ(executedAfterLoss(), 0);
  EXPECT_GT(arm_.executed.size(), 50u);
}

// The same process, back, tells what became of the commands of the connection that was lost.
TEST_P(FrozenProcess, LearnsWhatBecameOfEachCommand) {
  connect();
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
    pass(20ms);
    arm_.slow = inADrain();
    ASSERT_TRUE(eventually([this] { return arm_.inHandler == inADrain(); }));
    ASSERT_TRUE(eventually([this] { return ledger(*console_).underWay > 0; }));
    freeze();
    pass(2 * kSilence);
    const ConnectionReport sums = ledger(*console_);
    // Memory that both share tells even a client that is frozen.
    if (way().lane != Lane::Shm) {
      EXPECT_GT(sums.unknown + sums.underWay, 0u);
    }
    thaw();
    ASSERT_TRUE(eventually([this, round] { return teleop_.losses == round + 1; }));
  }
  teleop_.silent = true;
  ASSERT_TRUE(eventually([this] {
    const ConnectionReport sums = ledger(*console_);
    return teleop_.connected && sums.unknown == 0 && sums.underWay == 0;
  }));
  const ConnectionReport client = ledger(*console_), provider = ledger(*robot_);
  EXPECT_EQ(client.otherIncarnation, robot_->incarnation());
  EXPECT_EQ(provider.otherIncarnation, console_->incarnation());
  console_->stop();
  robot_->stop();
  EXPECT_EQ(client.sent, static_cast<unsigned>(teleop_.number - 1));
  EXPECT_EQ(client.executed, arm_.executed.size());
  EXPECT_EQ(client.sent, client.executed + client.refused + client.lost);
  EXPECT_EQ(provider.executed, arm_.executed.size());
  EXPECT_EQ(provider.sent, provider.executed + provider.refused + provider.lost);
}

// A command that a client sends before it knows that it has stood still comes too late.
TEST_P(FrozenProcess, IsConnectedAnew) {
  connect();
  freeze();
  pass(2 * kSilence);
  thaw();
  ASSERT_TRUE(eventually([this] { return teleop_.losses == 1; }));
  const Time begun = now();
  ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
  EXPECT_LT(now() - begun, 1s);
}

// A command that was accepted before the loss does not pass the gate that the loss has closed.
TEST_P(FrozenProcess, ExecutesNothingWhileItsOperatorIsAwaited) {
  connect(Resume::Operator);
  arm_.slow = inADrain();
  ASSERT_TRUE(eventually([this] { return arm_.inHandler == inADrain(); }));
  freeze();
  pass(2 * kSilence);
  thaw();
  ASSERT_TRUE(eventually([this] { return teleop_.losses == 1; }));
  ASSERT_TRUE(eventually([this] { return teleop_.connected.load(); }));
  pass(10ms);
  EXPECT_EQ(teleop_.accepted, 1);
  console_->resumeConnection("Teleop/Slave");
  ASSERT_TRUE(eventually([this] { return teleop_.accepted == 2; }));
  console_->stop();
  robot_->stop();
  EXPECT_EQ(executedAfterLoss(), 0);
}

// A client that stands still is gone for its provider when its lease has ended: while it still
// stands.
TEST_P(FrozenProcess, TellsOfASilentClientOnce) {
  connect();
  ASSERT_TRUE(eventually([this] { return arm_.clients == 1; }));
  freeze();
  const Time frozenAt = now();
  pass(2 * kSilence);
  if (isOneOf({Frozen::Client, Frozen::ClientsNetwork})) {
    EXPECT_EQ(arm_.silent, 1);
    EXPECT_LE(arm_.gone.load() - frozenAt, kSilence + 2ms);
  }
  thaw();
  ASSERT_TRUE(eventually([this] { return teleop_.losses == 1 && teleop_.connected; }));
  ASSERT_TRUE(eventually([this] { return arm_.clients == 2; }));
  pass(3 * kSilence);
  EXPECT_EQ(arm_.silent + arm_.closed, 1);
  EXPECT_EQ(arm_.clients, 2);
}

TEST_P(FrozenProcess, KeepsAConnectionThatBearsIt) {
  connect();
  freeze();
  pass(kSilence / 2);
  thaw();
  pass(3 * kSilence);
  EXPECT_EQ(teleop_.losses, 0);
}

}  // namespace
}  // namespace suture
