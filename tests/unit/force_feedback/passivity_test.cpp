// These test the passivity observer's account, and the damping that the controller adds.

#include "force_feedback/passivity.h"

#include <gtest/gtest.h>

namespace robots::test {
namespace {

using Eigen::Vector3d;

constexpr double kCycle = 0.001;  // s
constexpr double kBound = 1000;   // N.s/m

TEST(PassivityObserver, CountsWhatEachForceDid) {
  PassivityObserver observer;
  observer.beginAt({1, 1, 1});
  observer.movedTo({2, 2, 2});
  EXPECT_EQ(observer.energy(), Vector3d::Zero()) << "nothing pushed yet";
  observer.pushes({2, -3, 0});
  observer.movedTo({2.1, 2.1, 2.1});
  EXPECT_TRUE(observer.energy().isApprox(Vector3d(-0.2, 0.3, 0), 1e-12));
  observer.pushes({-4, -3, 0});
  observer.movedTo({2.2, 2.2, 2.2});
  EXPECT_TRUE(observer.energy().isApprox(Vector3d(0.2, 0.6, 0), 1e-12));
  observer.beginAt(Vector3d::Zero());
  observer.movedTo({1, 1, 1});
  EXPECT_EQ(observer.energy(), Vector3d::Zero()) << "the old force still counts";
}

TEST(PassivityController, LeavesAForceThatTheEnergyAllows) {
  const Vector3d force{5, -5, 5}, velocity{0.1, 0.1, -0.1};
  const Vector3d energy{0.001, 0, 0};
  EXPECT_EQ(damped(force, velocity, energy, kBound, kCycle), force);
}

// After the cycle the account is even, if the hand goes on as it does.
TEST(PassivityController, TakesWhatTheEnergyWouldLack) {
  const Vector3d force{5, -3, 1}, velocity{0.2, -0.1, -0.3}, energy{0.0004, 0, -0.0005};
  const Vector3d result = damped(force, velocity, energy, kBound, kCycle);
  const Vector3d after = energy - kCycle * result.cwiseProduct(velocity);
  EXPECT_LT(after.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PassivityController, BrakesNoHarderThanItsBound) {
  const Vector3d velocity{0.01, -0.01, 0.01}, energy{-1, -1, -1};
  const Vector3d result = damped({5, 5, 0}, velocity, energy, kBound, kCycle);
  // It takes a push away entirely, lets what brakes brake, and brakes.
  EXPECT_TRUE(result.isApprox(Vector3d(-10, 15, -10), 1e-9));
}

TEST(PassivityController, LeavesAHandAloneThatRests) {
  const Vector3d force{5, 5, 5};
  EXPECT_EQ(damped(force, Vector3d::Zero(), {-1, -1, -1}, kBound, kCycle), force);
  EXPECT_EQ(damped(force, {1e-320, -1e-320, 1e-200}, {-1, -1, -1}, kBound, kCycle), force);
}

}  // namespace
}  // namespace robots::test
