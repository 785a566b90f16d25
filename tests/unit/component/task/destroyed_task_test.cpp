// A program that destroys a task while its thread runs is told what to do instead.
#include <gtest/gtest.h>
#include <suture/component/task/periodic_task.h>

#include "support/pass.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

class Idle final : public PeriodicTask {
 public:
  Idle() : PeriodicTask({.period = 1h}) {}
  void run() override {}
};

void destroyARunningTask() {
  Idle task;
  task.start();
  pass(1ms);  // its first cycle is over, so nothing calls the run() of a class that is gone
}

TEST(DestroyedTaskDeathTest, AsksToStopTheTaskFirst) {
  EXPECT_DEATH(destroyARunningTask(), "is destroyed while its thread runs. Stop the task or its");
}

}  // namespace
}  // namespace suture
