// Whatever a person does, reading it never touches the heap: counted in front of the C library.

#include <gtest/gtest.h>

#include <chrono>

#include "person/event_file.h"
#include "person/gamepad_decoder.h"
#include "person/hand_goal.h"
#include "person/key_motion.h"
#include "person/terminal.h"
#include "support/allocations.h"
#include "unit/person/fifo.h"
#include "unit/person/pseudo_terminal.h"
#include "unit/person/recorded_events.h"

namespace robots::test {
namespace {

using suture::allocations;

TEST(Person, IsReadWithoutTheHeap) {
  Fifo fifo;
  fifo.plugIn();
  const PseudoTerminal pty;
  EventFile file(fifo.path());
  GamepadDecoder decoder{GamepadCalibration{}};
  Terminal terminal(pty.path());
  terminal.takeOver();
  KeyMotion keys{KeyMotionRates{}};
  Eigen::Isometry3d goal = Eigen::Isometry3d::Identity();
  fifo.write({axis(ABS_X, 32767), axis(ABS_HAT0X, 1), dropped(), report(), button(BTN_TL, true)});
  pty.type("wd i\x1b[A");
  suture::Time now = suture::fromNanoseconds(1);
  const std::uint64_t before = allocations();

  bool opened = file.open();
  for (int i = 0; i < 100; ++i) {
    now += std::chrono::milliseconds(1);
    for (const input_event& one : file.read()) decoder.take(one);
    for (const char key : terminal.read()) keys.take(key, now);
    goal = movedGoal(goal, goal, keys.at(now), 0.001);
    if (i == 50) fifo.pullOut();
    if (i == 60) opened = opened && file.open();
  }
  EXPECT_EQ(allocations() - before, 0u);
  EXPECT_TRUE(opened);
  EXPECT_FALSE(goal.linear().isIdentity()) << "the keys have not come";
}

}  // namespace
}  // namespace robots::test
