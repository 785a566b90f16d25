// A client may wait for a process longer than a manager lets one question wait, or for ever.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <memory>
#include <string>

#include "reference/still_arm.h"
#include "support/pass.h"
#include "support/refusal.h"
#include "support/test_thread.h"
#include "unit/manager/two_processes.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

class Patience : public testing::Test {
 protected:
  struct Arm final : PeriodicTask, StillArm {
    Arm() : PeriodicTask({.period = 1ms}) {}
    ~Arm() override { stop(); }
    void run() override {}
    Provided<reference::ArmLike> port{*this, "Arm", *this};
  };
  struct Caller final : Device {
    Required<reference::ArmLike> arm{*this, "Arm"};
  };

  Patience() { processes_.here.add("Caller", caller_); }

  std::string connect(const std::string& arm, Duration patience) {
    return refusal(
        [&] { processes_.here.connect("Caller/Arm", arm + "/Arm", {.patience = patience}); });
  }

  Arm arm_;
  Caller caller_;
  TwoProcesses processes_;
};

TEST_F(Patience, MayBeEndless) {
  processes_.there.add("PSM", arm_);
  processes_.start();
  EXPECT_EQ(connect("there:PSM", Duration::max()), "");
  EXPECT_TRUE(caller_.arm.hold.start().within(Duration::max()));
}

TEST_F(Patience, OutlivesOneQuestionsWait) {
  processes_.here.start();
  std::unique_ptr<Manager> late;
  TestThread other([&] {
    pass(75s);
    late = std::make_unique<Manager>("late", processes_.global.address());
    late->add("PSM", arm_);
    late->start();
  });
  EXPECT_EQ(connect("late:PSM", 90s), "");
  other.join();
}

}  // namespace
}  // namespace suture
