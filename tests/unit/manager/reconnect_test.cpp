// Connections are taken down and made anew while tasks run.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "reference/still_arm.h"
#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/manager/arm_and_client.h"
#include "unit/manager/two_processes.h"

namespace suture::test {
namespace {

using namespace std::chrono_literals;

/// Its run() ends when the test says so, so that a call stays under way.
struct Busy final : PeriodicTask, StillArm {
  Busy() : PeriodicTask({.period = 1ms}) {}
  ~Busy() override { stop(); }
  void run() override {
    while (busy) {
      inside = true;
      pass(1ms);
    }
  }
  std::atomic<bool> busy{false}, inside{false};
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

/// Counts how many of the channels that it has been shown still exist.
struct Census {
  void note(const Manager& manager) {
    for (const auto& channel : manager.channels()) seen.push_back(channel);
  }
  std::size_t alive() const {
    return static_cast<std::size_t>(
        std::count_if(seen.begin(), seen.end(), [](const auto& one) { return !one.expired(); }));
  }
  std::vector<std::weak_ptr<Channel>> seen;
};

TEST(Reconnect, WhileTasksRunToAnotherProvider) {
  ArmTask one, two;
  Client client;
  Manager manager("here");
  manager.add("One", one);
  manager.add("Two", two);
  manager.add("Teleop", client);
  manager.start();
  manager.connect("Teleop/Slave", "One/Arm");
  EXPECT_TRUE(eventually([&] { return one.holds > 0; }));
  manager.disconnect("Teleop/Slave");
  EXPECT_TRUE(eventually([&] { return client.error == Errc::NotConnected; }));
  EXPECT_EQ(two.holds, 0);
  manager.connect("Teleop/Slave", "Two/Arm");
  EXPECT_TRUE(eventually([&] { return two.holds > 0; }));
  EXPECT_EQ(manager.channels().size(), 1u);
}

TEST(Reconnect, ReplaysLatchedEvents) {
  OneProcess<ArmTask> here;
  here.connect();
  here.client.ask = true;
  EXPECT_TRUE(eventually([&] { return here.client.modes == 1; }));
  here.disconnect();
  here.connect();
  EXPECT_TRUE(eventually([&] { return here.client.modes == 2; }));
}

TEST(Reconnect, CallsUnderWayEnd) {
  OneProcess<Busy> here;
  here.connect();
  EXPECT_TRUE(eventually([&] { return here.arm.holds > 0; }));
  here.arm.busy = true;
  EXPECT_TRUE(eventually([&] { return here.arm.inside.load(); }));
  here.client.ask = true;
  EXPECT_TRUE(eventually([&] { return here.client.asked.load(); }));
  pass(20ms);
  EXPECT_EQ(here.client.answer, Errc::NotYet);
  here.disconnect();
  EXPECT_TRUE(eventually([&] { return here.client.answer == Errc::OutcomeUnknown; }));
  here.arm.busy = false;
}

/// `rest()` returns once the client runs nothing any more, so that it lets go of the connection
/// only if the manager makes it do so.
template <class Rest>
void disconnectAtRest(ArmTask& arm, Manager& clients, const std::string& to, const Rest& rest) {
  const auto connect = [&] { clients.connect("Teleop/Slave", to, {.patience = kPatience}); };
  connect();
  EXPECT_TRUE(eventually([&] { return arm.clients == 1; }));
  rest();
  clients.disconnect("Teleop/Slave");
  EXPECT_TRUE(eventually([&] { return arm.clients == 0; })) << "nobody has told the provider";
  connect();
  EXPECT_TRUE(eventually([&] { return arm.clients == 1; }));
}

TEST(Reconnect, AStoppedClientLetsGoAtOnce) {
  OneProcess<ArmTask> here;
  disconnectAtRest(here.arm, here.manager, "PSM/Arm", [&] {
    EXPECT_TRUE(eventually([&] { return here.arm.holds > 0; }));
    here.client.stop();
  });
  const int before = here.arm.holds;
  here.client.start();
  EXPECT_TRUE(eventually([&] { return here.arm.holds > before; }));
}

TEST(Reconnect, AnotherProcesssStoppedClientLetsGo) {
  ArmTask arm;
  Client client;
  TwoProcesses processes;
  processes.there.add("PSM", arm);
  processes.here.add("Teleop", client);
  processes.start();
  disconnectAtRest(arm, processes.here, "there:PSM/Arm", [&] {
    EXPECT_TRUE(eventually([&] { return arm.holds > 0; }));
    client.stop();
  });
}

TEST(Reconnect, AnUnusedDeviceLetsGoAtOnce) {
  struct Idle final : Device {
    Required<reference::ArmLike> slave{*this, "Slave"};
  } idle;
  ArmTask arm;
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Teleop", idle);
  manager.start();
  disconnectAtRest(arm, manager, "PSM/Arm", [&] { EXPECT_TRUE(idle.slave.hold()); });
}

TEST(Reconnect, AMissingConnectionCannotBeTakenDown) {
  Client client;
  Manager manager("here");
  manager.add("Teleop", client);
  EXPECT_EQ(refusal([&] { manager.disconnect("Teleop/Slave"); }),
            "disconnecting 'Teleop/Slave': it is not connected. Connect it with connect() first");
}

template <class Provider>
void reconnectOften() {
  OneProcess<Provider> here;
  Census census;
  for (int i = 0; i < 10'000; ++i) {
    here.connect();
    census.note(here.manager);
    if (i % 100 == 99) {
      ASSERT_TRUE(eventually([&] { return here.client.error == Errc{}; }));
      // The present channel may be alive, and those that no thread has looked at since they were
      // closed.
      ASSERT_TRUE(eventually([&] { return census.alive() <= 3; })) << census.alive();
    }
    here.disconnect();
    if (i % 100 == 99) {
      ASSERT_TRUE(eventually([&] { return here.client.error == Errc::NotConnected; }));
    }
  }
  EXPECT_EQ(census.seen.size(), 10'000u);
}

TEST(Reconnect, ManyTimesKeepNothingOfATask) { reconnectOften<ArmTask>(); }

TEST(Reconnect, ManyTimesKeepNothingOfADevice) { reconnectOften<ArmDevice>(); }

TEST(Reconnect, OverRpcKeepsOnlyTheNewChannel) {
  ArmTask arm;
  Client client;
  TwoProcesses processes;
  Manager &there = processes.there, &here = processes.here;
  there.add("PSM", arm);
  here.add("Teleop", client);
  processes.start();
  Census census;
  for (int i = 0; i < 100; ++i) {
    here.connect("Teleop/Slave", "there:PSM/Arm",
                 {.patience = kPatience, .contract = {.onLoss = Fallback::Fault}});
    const auto channels = here.channels();
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front()->status, ChannelStatus::Connected);
    for (const auto& old : census.seen) EXPECT_NE(old.lock(), channels.front());
    const int before = arm.holds;
    ASSERT_TRUE(eventually([&] { return arm.holds > before; }));
    census.note(here);
    census.note(there);
    here.disconnect("Teleop/Slave");
    EXPECT_TRUE(here.channels().empty());
    EXPECT_TRUE(eventually([&] { return client.error == Errc::NotConnected; }));
  }
  here.connect("Teleop/Slave", "there:PSM/Arm");
  EXPECT_TRUE(eventually([&] { return census.alive() == 0; })) << census.alive();
  EXPECT_TRUE(eventually([&] { return there.channels().size() == 1; }));
  EXPECT_EQ(client.state(), ComponentState::Running) << "what is taken down is not lost";
}

TEST(Reconnect, TheNewRpcChannelIsShown) {
  TemporaryDirectory directory;
  loop::ControlThread control;
  GlobalManager global{control, "unix:" + directory.file("manager.sock")};
  Client client;
  Manager here{"here", global.address()};
  here.add("Teleop", client);
  here.start();
  std::shared_ptr<Channel> lost;
  {
    ArmTask arm;
    Manager there{"there", global.address()};
    there.add("PSM", arm);
    there.start();
    here.connect("Teleop/Slave", "there:PSM/Arm");
    lost = here.channels().at(0);
  }
  EXPECT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
  ArmTask arm;
  Manager there{"there", global.address()};
  there.add("PSM", arm);
  there.start();
  EXPECT_TRUE(eventually([&] { return arm.holds > 0; }));
  const auto channels = here.channels();
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_NE(channels.front(), lost);
  EXPECT_EQ(channels.front()->status, ChannelStatus::Connected);
  EXPECT_TRUE(eventually(
      [&] { return channels.front()->counts->heard(ConnectionEnd::Client).executed > 0; }));
}

/// If no lane is given, provider and client are in one process.
class StartedAgain : public testing::TestWithParam<std::optional<Lane>> {
 protected:
  void begin() {
    processes.there.add("PSM", arm);
    clients.add("Teleop", client);
    processes.start();
    connect();
    ASSERT_TRUE(eventually([&] { return arm.holds > 0 && client.error == Errc{}; }));
  }
  void connect() {
    clients.connect("Teleop/Slave", GetParam() ? "there:PSM/Arm" : "PSM/Arm",
                    {.lane = GetParam().value_or(Lane::Auto)});
  }

  ArmTask arm;
  Client client;
  TwoProcesses processes;
  Manager& clients = GetParam() ? processes.here : processes.there;
};

INSTANTIATE_TEST_SUITE_P(Lanes, StartedAgain,
                         testing::Values(std::nullopt, Lane::Shm, Lane::Frame, Lane::Rpc),
                         [](const auto& row) {
                           return std::string(row.param ? toString(*row.param) : "local");
                         });

TEST_P(StartedAgain, ClientsLoseItThoughItHasFaulted) {
  begin();
  arm.broken = true;
  ASSERT_TRUE(eventually([&] { return client.error == Errc::Faulted; }));
  arm.stop();
  EXPECT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
}

TEST_P(StartedAgain, ClientsLoseItUntilTheyReconnect) {
  begin();
  arm.stop();
  ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
  const int before = arm.holds;
  arm.start();
  pass(3s);
  EXPECT_EQ(client.error, Errc::Lost);
  EXPECT_EQ(arm.holds, before) << "nothing of the old connection is executed";
  clients.disconnect("Teleop/Slave");
  connect();
  EXPECT_TRUE(eventually([&] { return arm.holds > before && client.error == Errc{}; }));
}

TEST(Reconnect, AFailedReconnectSaysWhy) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager global(control, "unix:" + directory.file("m.sock"));
  const std::string name = "here:Teleop/Slave -> there:PSM/Arm";
  Client client;
  Manager here{"here", global.address()};
  here.add("Teleop", client);
  here.start();
  const auto provider = [&global](const char* component, ArmTask& arm) {
    auto there = std::make_unique<Manager>("there", global.address());
    there->add(component, arm);
    there->start();
    return there;
  };
  ArmTask first, renamed, second;
  auto there = provider("PSM", first);
  here.connect("Teleop/Slave", "there:PSM/Arm");
  there = nullptr;
  ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; }));
  EXPECT_TRUE(here.whyNotBack().empty()) << "it is not there, which the loss has told";

  there = provider("ECM", renamed);
  ASSERT_TRUE(eventually([&] { return !here.whyNotBack().empty(); }));
  const std::string why = here.whyNotBack().at(name);
  EXPECT_TRUE(suture::contains(why, "process 'there' has")) << why;
  EXPECT_TRUE(suture::contains(why, "'ECM'")) << why;
  there = nullptr;

  there = provider("PSM", second);
  ASSERT_TRUE(eventually([&] { return client.error == Errc{}; }));
  EXPECT_TRUE(here.whyNotBack().empty()) << here.whyNotBack().at(name);
  EXPECT_FALSE(here.whyLost().at(name).empty()) << "that stays";
}

}  // namespace
}  // namespace suture::test
