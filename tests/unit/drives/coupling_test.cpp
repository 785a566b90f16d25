// Drives speak of actuators, whatever their joints are.

#include "drives/coupling.h"

#include <gtest/gtest.h>

#include <chrono>

#include "drives/simulated_drives.h"

namespace robots::test {
namespace {

using Seven = Coupling<7>::Vector;
enum Disc { Roll = 3, Pitch, Yaw, Jaw };

TEST(PsmCoupling, EachDiscTurnsWhatItsCablesLeadTo) {
  const auto turned = [](int disc) { return psmCoupling().joints(Seven::Unit(disc)); };
  EXPECT_TRUE(turned(0).isApprox(Seven::Unit(0)));
  EXPECT_TRUE(turned(2).isApprox(Seven::Unit(2)));
  EXPECT_TRUE(turned(Roll).isApprox(-1.5632 * Seven::Unit(Roll)));
  EXPECT_TRUE(turned(Pitch).isApprox(1.0186 * Seven::Unit(Pitch) - 0.8306 * Seven::Unit(Yaw)));
  EXPECT_TRUE(turned(Yaw).isApprox(0.6089 * Seven::Unit(Yaw) - 1.2177 * Seven::Unit(Jaw)));
  EXPECT_TRUE(turned(Jaw).isApprox(0.6089 * Seven::Unit(Yaw) + 1.2177 * Seven::Unit(Jaw)));
}

TEST(PsmCoupling, LeadsThereAndBack) {
  const Coupling<7> coupling = psmCoupling();
  for (int i = 0; i < 100; ++i) {
    const Seven any = Seven::Random();
    EXPECT_LT((coupling.joints(coupling.actuators(any)) - any).norm(), 1e-12);
    EXPECT_LT((coupling.jointEfforts(coupling.actuatorEfforts(any)) - any).norm(), 1e-12);
  }
}

TEST(PsmCoupling, KeepsPower) {
  const Coupling<7> coupling = psmCoupling();
  for (int i = 0; i < 100; ++i) {
    const Seven velocity = Seven::Random(), effort = Seven::Random();
    EXPECT_NEAR(coupling.actuatorEfforts(effort).dot(coupling.actuators(velocity)),
                effort.dot(velocity), 1e-12);
  }
}

/// Joints that are where they are told to be, and tell an effort.
class ObedientJoints final : public SimulatedJoints<7> {
 public:
  void advance(double) override {}
  void command(const Joints& setpoint) override { position_ = setpoint; }
  void brake() override {}
  const Joints& measured() const override { return position_; }
  Joints velocity() const override { return Joints::Constant(0.5); }
  Joints effort() const override { return Joints::Constant(2); }

 private:
  Joints position_ = Joints::Constant(0.1);
};

TEST(CoupledDrives, TellAndTakeWhatIsOfActuators) {
  const Coupling<7> coupling = psmCoupling();
  SimulatedDrives<7> drives(std::make_unique<ObedientJoints>(), coupling);
  suture::Time time = suture::fromNanoseconds(1'000'000'000);
  drives.permit(true);
  drives.step(time);
  const auto told = [&](const auto& list) { return Seven(Seven::Map(list.data())); };
  EXPECT_TRUE(told(drives.feedback().position).isApprox(coupling.actuators(Seven::Constant(0.1))));
  EXPECT_TRUE(told(drives.feedback().velocity).isApprox(coupling.actuators(Seven::Constant(0.5))));
  EXPECT_TRUE(
      told(drives.feedback().effort).isApprox(coupling.actuatorEfforts(Seven::Constant(2))));

  drives.power_on(drives.feedback().permitted);
  DriveGoal goal;
  goal.joints = 7;
  Seven::Map(goal.position.data()) = Seven::LinSpaced(0.1, 0.7);
  drives.servo_jp(goal);
  drives.step(time += std::chrono::milliseconds(1));
  EXPECT_TRUE(told(drives.feedback().position).isApprox(Seven::LinSpaced(0.1, 0.7)));
}

}  // namespace
}  // namespace robots::test
