// Drives speak of actuators, whatever their joints are.

#include "drives/coupling.h"

#include <gtest/gtest.h>

#include <chrono>

#include "drives/simulated_drives.h"
#include "dynamics/davinci_inertia.h"

namespace robots::test {
namespace {

using Seven = Coupling<7>::Vector;
enum Disc { Roll = 3, Pitch, Yaw, Jaw };

TEST(PsmCoupling, EachDiscTurnsItsCablesJoints) {
  const auto turned = [](int disc) { return psmCoupling().joints(Seven::Unit(disc)); };
  EXPECT_TRUE(turned(0).isApprox(Seven::Unit(0)));
  EXPECT_TRUE(turned(2).isApprox(Seven::Unit(2)));
  EXPECT_TRUE(turned(Roll).isApprox(-1.5632 * Seven::Unit(Roll)));
  EXPECT_TRUE(turned(Pitch).isApprox(1.0186 * Seven::Unit(Pitch) - 0.8306 * Seven::Unit(Yaw)));
  EXPECT_TRUE(turned(Yaw).isApprox(0.6089 * Seven::Unit(Yaw) - 1.2177 * Seven::Unit(Jaw)));
  EXPECT_TRUE(turned(Jaw).isApprox(0.6089 * Seven::Unit(Yaw) + 1.2177 * Seven::Unit(Jaw)));
}

// The motor of the shoulder carries the forearm along as a parallelogram does, so that its
// direction stays, and the platform turns back by as much of that as its cables run over.
TEST(MtmCoupling, EachMotorTurnsItsCablesJoints) {
  enum Motor { OuterYaw, Shoulder, Elbow, Platform };
  const auto turned = [](int motor) { return mtmCoupling().joints(Seven::Unit(motor)); };
  EXPECT_TRUE(turned(OuterYaw).isApprox(Seven::Unit(OuterYaw)));
  EXPECT_TRUE(turned(Shoulder).isApprox(Seven::Unit(Shoulder) - Seven::Unit(Elbow) +
                                        0.6697 * Seven::Unit(Platform)));
  EXPECT_TRUE(turned(Elbow).isApprox(Seven::Unit(Elbow) - 0.6697 * Seven::Unit(Platform)));
  for (const int alone : {3, 4, 5, 6}) EXPECT_TRUE(turned(alone).isApprox(Seven::Unit(alone)));
}

// Both are published, and each by itself: what the motors can, and what that comes to at the
// joints.
TEST(MtmCoupling, MotorEffortsBecomeJointEfforts) {
  const auto mechanics = dynamics::mtmMechanics();
  const Seven most = mtmCoupling().jointEffortBounds(mechanics.motor_limit);
  EXPECT_LT((most - mechanics.effort_limit).cwiseAbs().maxCoeff(), 1e-7) << most.transpose();
}

TEST(MtmCoupling, ActuatorErrorsBoundJoints) {
  const Seven bounds = mtmCoupling().jointBounds(Seven::Constant(1));
  EXPECT_DOUBLE_EQ(bounds[2], 2);
  EXPECT_DOUBLE_EQ(bounds[3], 1 + 2 * 0.6697);
}

TEST(MtmCoupling, LeavesTheGripperAlone) {
  const Coupling<8> coupling = withTool(mtmCoupling());
  using Eight = Coupling<8>::Vector;
  EXPECT_TRUE(coupling.joints(Eight::Unit(7)).isApprox(Eight::Unit(7)));
  const Seven any = Seven::Random();
  Eight all;
  all << any, 0.3;
  EXPECT_TRUE(coupling.joints(all).head<7>().isApprox(mtmCoupling().joints(any)));
}

class Couplings : public testing::TestWithParam<Coupling<7>> {};

INSTANTIATE_TEST_SUITE_P(OfArms, Couplings, testing::Values(psmCoupling(), mtmCoupling()));

TEST_P(Couplings, LeadThereAndBack) {
  const Coupling<7>& coupling = GetParam();
  for (int i = 0; i < 100; ++i) {
    const Seven any = Seven::Random();
    EXPECT_LT((coupling.joints(coupling.actuators(any)) - any).norm(), 1e-12);
    EXPECT_LT((coupling.jointEfforts(coupling.actuatorEfforts(any)) - any).norm(), 1e-12);
  }
}

TEST_P(Couplings, KeepThePowerOfTheJoints) {
  const Coupling<7>& coupling = GetParam();
  for (int i = 0; i < 100; ++i) {
    const Seven velocity = Seven::Random(), effort = Seven::Random();
    EXPECT_NEAR(coupling.actuatorEfforts(effort).dot(coupling.actuators(velocity)),
                effort.dot(velocity), 1e-12);
  }
}

/// ObedientJoints are where they are told to be, and tell an effort.
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
