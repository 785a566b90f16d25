// An operator who interrupts the scripted surgeon again and again does not lead it astray.

#include "surgeon/surgeon.h"

#include <gtest/gtest.h>
#include <suture/manager/manager.h>

#include <chrono>

#include "integration/teleoperation/scene/scripted_arm.h"
#include "support/pass.h"
#include "surgeon/pause.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

// Each time it has had time to come back to the middle of its path, and is somewhere else on it.
TEST(Surgeon, StaysAroundItsBeginning) {
  ScriptedArm master;
  Surgeon surgeon{SurgeonParameters{}};
  suture::Manager manager{"console"};
  manager.add("MTM", master);
  manager.add("Surgeon", surgeon);
  manager.connect("Surgeon/Master", "MTM/Arm");
  manager.start();
  double furthest = 0;
  for (int i = 0; i < 10; ++i) {
    pass(3s);
    furthest = std::max(furthest, master.pose().translation().norm());
    manager.suspend("Surgeon");
    pass(2 * kLongestPause);
    const Eigen::Isometry3d before = master.pose();
    manager.resume("Surgeon");
    pass(10ms);
    EXPECT_LT((master.pose().translation() - before.translation()).norm(), 1e-3) << "it leapt";
  }
  manager.stop();
  EXPECT_GT(furthest, 0.05) << "it never set out";
  EXPECT_LT(furthest, 0.2) << "its path walked away";
}

}  // namespace
}  // namespace robots::test
