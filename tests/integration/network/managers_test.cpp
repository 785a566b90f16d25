// Several global managers run, each as a process, and processes fall silent.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/manager/manager.h>

#include <csignal>
#include <future>
#include <memory>

#include "integration/network/arm.h"
#include "integration/network/console.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// A ManagerProcess is suture-manager, and knows where it listens.
struct ManagerProcess : Child {
  explicit ManagerProcess(const std::string& at) : Child({paths::kSutureManager, "--listen", at}) {
    const std::string ready = line(), expected = "suture-manager: ready on ";
    EXPECT_TRUE(ready.starts_with(expected)) << ready;
    address = ready.substr(expected.size());
  }
  std::string address;
};

/// An Asker is a process that asks for the arm.
struct Asker {
  Asker(const std::string& name, const std::string& managers) : manager(name, managers) {
    manager.add("Console", console);
    manager.start();
  }
  void connect(Duration patience = 10s) {
    manager.connect("Console/Arm", "left:PSM/Arm", {.patience = patience});
  }

  Console console;
  Manager manager;
};

class ManagersTest : public testing::TestWithParam<const char*> {
 protected:
  std::unique_ptr<ManagerProcess> managerAt(const std::string& file) const {
    return std::make_unique<ManagerProcess>(
        std::string(GetParam()) == "unix" ? "unix:" + directory_.file(file) : "tcp://127.0.0.1:0");
  }
  std::unique_ptr<Child> provider() const {
    auto child = std::make_unique<Child>(std::vector<std::string>{paths::kArmHost, all_, "left"});
    EXPECT_EQ(child->line(), "ready");
    return child;
  }
  /// Expects that a process which has known no other finds the provider.
  void expectFound(double x) const {
    Asker fresh("fresh", all_);
    fresh.connect();
    EXPECT_TRUE(reaches(fresh.console, x));
  }

  const TemporaryDirectory directory_;
  std::unique_ptr<ManagerProcess> first_ = managerAt("1.sock"), second_ = managerAt("2.sock");
  const std::string all_ = first_->address + "," + second_->address;
};

INSTANTIATE_TEST_SUITE_P(Sockets, ManagersTest, testing::Values("unix", "tcp"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ManagersTest, TheNextKnowsAllAfterAKill) {
  const auto child = provider();
  Asker old("old", all_);
  old.connect();
  ASSERT_TRUE(reaches(old.console, 1));
  const auto channels = old.manager.channels();
  const std::string firstAddress = first_->address;
  first_->end(SIGKILL);
  expectFound(2);
  EXPECT_TRUE(eventually([&] { return old.manager.missingGlobalManager() == firstAddress; }));

  first_ = std::make_unique<ManagerProcess>(firstAddress);
  EXPECT_TRUE(eventually([&] { return old.manager.missingGlobalManager().empty(); }));
  second_->end(SIGKILL);
  expectFound(3);
  EXPECT_TRUE(reaches(old.console, 4));
  EXPECT_EQ(old.manager.channels(), channels) << "the same connection all the time";
  EXPECT_EQ(channels.at(0)->status, ChannelStatus::Connected);
  EXPECT_TRUE(old.manager.whyLost().empty());
}

TEST_P(ManagersTest, TheNextKnowsAllAfterAStop) {
  const auto child = provider();
  Asker old("old", all_);
  old.connect();
  const auto channels = old.manager.channels();
  first_->signal(SIGSTOP);
  expectFound(1);
  EXPECT_TRUE(eventually([&] { return old.manager.missingGlobalManager() == first_->address; }))
      << "it is silent";
  EXPECT_TRUE(reaches(old.console, 2));
  first_->signal(SIGCONT);
  EXPECT_TRUE(eventually([&] { return old.manager.missingGlobalManager().empty(); }));
  EXPECT_EQ(old.manager.channels(), channels);
  EXPECT_TRUE(old.manager.whyLost().empty());
}

TEST_P(ManagersTest, ANameIsTakenWhicheverManagerLives) {
  const auto child = provider();
  first_->end(SIGKILL);
  const std::string error = refusal([&] { Manager("left", all_); });
  EXPECT_TRUE(contains(error, "register process 'left': the name is held by")) << error;
}

TEST_P(ManagersTest, AFailedSearchNamesAllManagers) {
  first_->end(SIGKILL);
  second_->end(SIGKILL);
  const std::string error = refusal([&] { Manager("left", all_, 20ms); });
  EXPECT_TRUE(contains(error, "suture-manager --listen " + first_->address)) << error;
  EXPECT_TRUE(contains(error, second_->address)) << error;
}

// One question to a manager has 2 s, so this start has to ask again.
TEST_P(ManagersTest, AStartAwaitsAStoppedManager) {
  first_->signal(SIGSTOP);
  const Time began = now();
  const std::string error = refusal([&] { Manager("left", first_->address, 2500ms); });
  EXPECT_GE(now() - began, 2500ms);
  EXPECT_TRUE(
      contains(error, "talk to " + first_->address + ": what listens there does not answer"))
      << error;
  first_->signal(SIGCONT);
}

TEST_P(ManagersTest, AStartSucceedsOnceTheManagerResumes) {
  first_->signal(SIGSTOP);
  auto started = std::async(std::launch::async, [&] { Manager("left", first_->address); });
  EXPECT_EQ(started.wait_for(2500ms), std::future_status::timeout) << "it has to wait";
  first_->signal(SIGCONT);
  started.get();
}

TEST_P(ManagersTest, AConnectionWaitsForAManager) {
  const auto child = provider();
  Asker old("old", all_);
  const std::string firstAddress = first_->address;
  first_->end(SIGKILL);
  second_->end(SIGKILL);
  ASSERT_TRUE(eventually([&] { return old.manager.missingGlobalManager() == all_; }));
  first_ = std::make_unique<ManagerProcess>(firstAddress);
  old.connect();
  EXPECT_TRUE(reaches(old.console, 1));
}

TEST_P(ManagersTest, ASilentProcessIsNotHandedOut) {
  const auto child = provider();
  Asker asker("asker", all_);
  child->signal(SIGSTOP);
  std::string error;
  EXPECT_TRUE(eventually([&] {
    error = refusal([&] { asker.connect(1ms); });
    return contains(error, "has not renewed its name in time");
  })) << error;
  child->signal(SIGCONT);
  asker.connect();
  EXPECT_TRUE(reaches(asker.console, 1));
}

TEST_P(ManagersTest, ASilentProcesssNameIsFree) {
  const auto child = provider();
  child->signal(SIGSTOP);
  reference::HostedArm arm;
  std::unique_ptr<Manager> successor;
  ASSERT_TRUE(eventually([&] {
    return refusal([&] { successor = std::make_unique<Manager>("left", all_); }).empty();
  }));
  successor->add("PSM", arm);
  successor->start();
  child->signal(SIGCONT);
  Asker asker("asker", all_);
  asker.connect();
  EXPECT_TRUE(reaches(asker.console, 1));

  const auto channels = asker.manager.channels();
  successor.reset();
  EXPECT_TRUE(eventually([&] { return !asker.manager.whyLost().empty(); })) << "it was that one";
  // The reason is told before the loss, so the old connection may still look well.
  EXPECT_TRUE(eventually([&] { return asker.manager.channels() != channels; }));
  EXPECT_TRUE(eventually([&] { return asker.console.arm.connected(); })) << "now it is the other";
  EXPECT_TRUE(reaches(asker.console, 2));
}

}  // namespace
}  // namespace suture
