// Commands that await an operator after a loss or a stale read are let through again.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>
#include <suture/standard/lifecycle.suture.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/manager/arm_and_client.h"

namespace suture::test {
namespace {

TEST(Resuming, AStaleReadAwaitsTheOperator) {
  OneProcess<ArmTask> here;
  here.connect({.maxAge = 1ns, .resume = Resume::Operator});
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc{}; }));
  EXPECT_EQ(refusal([&] { here.manager.resumeConnection("Teleop/Slave"); }),
            "resuming connection 'Teleop/Slave': it does not await an operator. Nothing has to be "
            "done");
  here.client.read = true;
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc::AwaitingOperator; }));
  here.client.read = false;
  pass(5ms);
  EXPECT_EQ(here.client.error, Errc::AwaitingOperator);
  here.manager.resumeConnection("Teleop/Slave");
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc{}; }));
}

/// Speaks to the life of a client, from the same process or another.
struct Operator final : Device {
  std::optional<ResumeOutcome> resume(const std::string& required) {
    const auto answer = life.resume_connection.start(required).within(kPatience);
    return answer ? std::optional(*answer) : std::nullopt;
  }
  Required<Lifecycle> life{*this, "Life"};
};

TEST(Resuming, TheOperatorAsksTheComponentItself) {
  Operator person;
  OneProcess<ArmTask> here;
  here.manager.add("Operator", person);
  here.manager.start();
  here.manager.connect("Operator/Life", "Teleop/component");
  EXPECT_EQ(person.resume("Nothing"), ResumeOutcome::NoSuchInterface);
  EXPECT_EQ(person.resume("Slave"), ResumeOutcome::NotConnected);
  here.connect({.maxAge = 1ns, .resume = Resume::Operator});
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc{}; }));
  EXPECT_EQ(person.resume("Slave"), ResumeOutcome::NotAwaiting);
  here.client.read = true;
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc::AwaitingOperator; }));
  here.client.read = false;
  pass(5ms);
  here.manager.suspend("PSM");
  EXPECT_EQ(person.resume("Slave"), ResumeOutcome::ProviderLost);
  EXPECT_EQ(refusal([&] { here.manager.resumeConnection("Teleop/Slave"); }),
            "resuming connection 'Teleop/Slave': the provider is suspended. Have its provider run "
            "again, and look at it, first");
  here.manager.resume("PSM");
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc::AwaitingOperator; }));
  EXPECT_EQ(person.resume("Slave"), ResumeOutcome::Resumed);
  EXPECT_TRUE(eventually([&] { return here.client.error == Errc{}; }));
}

/// A DeviceClient is a client without a thread of its own.
struct DeviceClient final : Device {
  Required<reference::ArmLike> slave{*this, "Slave"};
};

TEST(Resuming, ADeviceResumesAtItsNextUse) {
  ArmTask arm;
  DeviceClient client;
  Operator person;
  Manager manager("here");
  manager.add("PSM", arm);
  manager.add("Teleop", client);
  manager.add("Operator", person);
  manager.start();
  manager.connect("Operator/Life", "Teleop/component");
  manager.connect("Teleop/Slave", "PSM/Arm",
                  {.patience = 1s, .contract = {.maxAge = 1ns, .resume = Resume::Operator}});
  EXPECT_TRUE(eventually([&] { return client.slave.measured_cp().error() == Errc::Stale; }));
  EXPECT_EQ(client.slave.hold().error(), Errc::AwaitingOperator);
  EXPECT_EQ(person.resume("Slave"), ResumeOutcome::Asked);
  EXPECT_TRUE(client.slave.hold());
}

TEST(Resuming, AResumeCoversNoLaterLoss) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager global(control, "unix:" + directory.file("m.sock"));
  DeviceClient client;
  Operator person;
  Manager here{"here", global.address()};
  here.add("Teleop", client);
  here.add("Operator", person);
  here.start();
  here.connect("Operator/Life", "Teleop/component");
  std::shared_ptr<Channel> lost;
  {
    ArmTask arm;
    Manager there{"there", global.address()};
    there.add("PSM", arm);
    there.start();
    here.connect("Teleop/Slave", "there:PSM/Arm",
                 {.patience = 1s, .contract = {.resume = Resume::Operator}});
    EXPECT_TRUE(client.slave.hold());
    EXPECT_EQ(person.resume("Slave"), ResumeOutcome::Asked);
    for (const auto& one : here.channels()) {
      if (one->terms.watch != nullptr && one->name().find("Slave") != std::string::npos) lost = one;
    }
    ASSERT_NE(lost, nullptr);
  }
  ArmTask arm;
  Manager there{"there", global.address()};
  there.add("PSM", arm);
  there.start();
  EXPECT_TRUE(eventually([&] {
    const auto channels = here.channels();
    return std::any_of(channels.begin(), channels.end(), [&](const auto& one) {
      return one != lost && one->terms.watch == lost->terms.watch &&
             one->status == ChannelStatus::Connected;
    });
  }));
  EXPECT_EQ(client.slave.hold().error(), Errc::AwaitingOperator);
  EXPECT_EQ(arm.holds, 0);
}

}  // namespace
}  // namespace suture::test
