// An arm's cycle never touches the heap once it is constructed: counted at operator new, which this
// executable replaces.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <new>

#include "arm/kinematics/davinci.h"
#include "arm/simulated_arm.h"

namespace {
thread_local std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// Not inlined, or g++ 12 takes the pair for a mismatch.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace robots::test {
namespace {

struct Silent {
  void operating_state(const OperatingState&) {}
  void goal_reached(bool) {}
  void warning(ArmWarning) {}
};

TEST(SimulatedArm, NeverAllocatesInItsCycle) {
  using Joints = ArmModel<7>::Joints;
  SimulatedArm<7> arm({.chain = kinematics::mtmLeft(),
                       .joint_names = {"a", "b", "c", "d", "e", "f", "g"},
                       .parked = Joints::Constant(0.1),
                       .home = Joints::Constant(0.2),
                       .rate_limit = Joints::Constant(4),
                       .time_constant = 0.01});
  const JointGoal elsewhere{std::vector<double>(7, 0.15), {}};
  suture::Time time = suture::fromNanoseconds(1);
  const std::size_t before = allocations;

  arm.enable();
  arm.home();
  for (int i = 0; i < 1000; ++i) {
    time += std::chrono::milliseconds(1);
    if (i == 300) arm.move_jp(elsewhere);
    if (i > 600) {
      PoseStamped goal = arm.setpoint_cp();
      goal.pose.translation().x() += i % 100 == 0 ? 1.0 : 0.0001;  // out of reach now and then
      arm.servo_cp(goal);
    }
    arm.step(time);
    arm.announce(Silent{});
  }
  EXPECT_EQ(allocations - before, 0u);
}

}  // namespace
}  // namespace robots::test
