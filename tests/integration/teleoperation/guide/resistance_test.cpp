// The guide lets hands feel what the fixtures forbid them: by a contract, or by the masters'
// motors.

#include <algorithm>

#include "hand/hand.h"
#include "integration/teleoperation/scene/guided_arms.h"
#include "surgeon/operator.h"

namespace robots::test {
namespace {

constexpr double kSpeed = 0.2;                // m/s, of hands
constexpr double kDamping = 50;               // N.s/m
constexpr double kPress = kSpeed * kDamping;  // N

class GuideResistance : public Guide {
 protected:
  explicit GuideResistance(const GuideParameters& parameters = kPatient) : Guide({}, parameters) {
    eyes_.seen_.knot.x() = 0.0303;  // the corridor's edge: 0.3 mm, and 0.3 m wider for each metre
    pass(50ms);
    forgetWrenches();
  }
  void forgetWrenches() {
    arms_[0].forgetGoals();
    arms_[1].forgetGoals();
  }
  void moveHands(const Vector3d& direction) { moveMasters(kSpeed * 0.05 * direction, 50); }
};

TEST_F(GuideResistance, IsWhatTheCorridorForbids) {
  moveHands({1, 0, 0});
  const ForbiddenMotion forbidden = guide_.forbidden_motion();
  ASSERT_TRUE(forbidden.valid);
  const double forbiddenSpeed = GuideParameters{}.scale * kSpeed;
  EXPECT_NEAR(forbidden.left.x(), forbiddenSpeed, 0.01 * forbiddenSpeed);
  EXPECT_NEAR(forbidden.right.x(), forbiddenSpeed, 0.01 * forbiddenSpeed);
  EXPECT_LT(forbidden.left.tail<2>().norm(), 0.01 * forbiddenSpeed);
}

TEST_F(GuideResistance, IsNoneWhereHandsMayGo) {
  moveHands({-1, 0, -1});
  ASSERT_TRUE(guide_.forbidden_motion().valid);
  EXPECT_LT(guide_.forbidden_motion().left.norm(), 1e-6);
}

TEST_F(GuideResistance, EndsWithTheHandsMotion) {
  moveHands({1, 0, 0});
  pass(10ms);
  EXPECT_LT(guide_.forbidden_motion().left.norm(), 1e-6);
}

TEST_F(GuideResistance, IsNotValidWithoutGuiding) {
  moveHands({1, 0, 0});
  eyes_.covered = true;
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  pass(2ms);
  EXPECT_FALSE(guide_.forbidden_motion().valid);
}

TEST_F(GuideResistance, SendsMastersNothingUnlessItIsTold) {
  moveHands({1, 0, 0});
  EXPECT_TRUE(arms_[0].wrenches().empty());
  EXPECT_TRUE(arms_[1].wrenches().empty());
}

class PressingMasters : public GuideResistance {
 protected:
  PressingMasters()
      : GuideResistance({.preparation_limit = kPreparationLimit, .master_damping = kDamping}) {
    manager_.connect("Guide/Pedals", "Console/Pedals");
    manager_.connect("Guide/Presence", "Console/Presence");
    pass(10ms);
    EXPECT_TRUE(becomes(GuidanceState::Guiding));
  }
  Vector3d force(std::size_t which) const { return arms_[which].wrenches().back().force; }
};

/// Wrenches are in the directions of the master's tip.
TEST_F(PressingMasters, PressAgainstTheirHands) {
  arms_[0].place(arms_[0].pose() * Eigen::AngleAxisd(EIGEN_PI / 2, Vector3d::UnitZ()));
  pass(50ms);
  moveHands({1, 0, 0});
  EXPECT_LT((force(0) - Vector3d(0, kPress, 0)).norm(), 0.02 * kPress) << force(0).transpose();
  EXPECT_LT((force(1) - Vector3d(-kPress, 0, 0)).norm(), 0.02 * kPress) << force(1).transpose();
}

TEST_F(PressingMasters, FloatWhereTheyMayGo) {
  moveHands({-1, 0, 0});
  EXPECT_GT(arms_[0].wrenches().size(), 40u) << "it is held";
  EXPECT_LT(force(0).norm(), 1e-3);
}

TEST_F(PressingMasters, FloatWhileTheClutchIsPressed) {
  console_.clutch = true;
  ASSERT_TRUE(becomes(GuidanceState::Clutched));
  pass(2ms);
  forgetWrenches();
  moveHands({1, 0, 0});
  EXPECT_GT(arms_[0].wrenches().size(), 40u) << "it is held";
  EXPECT_EQ(force(0), Vector3d::Zero());
}

/// A master whose stream ends holds.
TEST_F(PressingMasters, HoldWithoutASurgeon) {
  console_.present = false;
  ASSERT_TRUE(becomes(GuidanceState::Clutched));
  pass(2ms);
  forgetWrenches();
  pass(50ms);
  EXPECT_TRUE(arms_[0].wrenches().empty());
}

TEST_F(PressingMasters, HoldWhileNoKnotIsSeen) {
  eyes_.covered = true;
  ASSERT_TRUE(becomes(GuidanceState::Blind));
  pass(2ms);
  forgetWrenches();
  pass(50ms);
  EXPECT_TRUE(arms_[0].wrenches().empty());
}

/// An operator at the masters wants the knot beyond the corridor for 2 s.
class FeelingOperator : public GuideResistance {
 public:
  static constexpr double kBeyond = 0.02;  // m

  explicit FeelingOperator(bool feels, suture::Duration delay = {})
      : operator_({.target = eyes_.seen_.knot + Vector3d(kBeyond, 0, 0),
                   .remnant = 0,
                   .tremor = 0,
                   .feel_fixtures = feels}) {
    manager_.add("Operator", operator_);
    manager_.connect("Operator/Left", "LeftMaster/Arm");
    manager_.connect("Operator/Right", "RightMaster/Arm");
    manager_.connect("Operator/Vision", "Eyes/Vision");
    manager_.connect("Operator/Registration", "Registration/Registration");
    manager_.connect("Operator/Guidance", "Guide/Guidance",
                     {.patience = 1s, .delay = {.answers = delay}});
    manager_.start();
    const double before = arms_[0].pose().translation().x();
    for (int i = 0; i < 2000; ++i) {
      pass(1ms);
      leastEnergy = std::min({leastEnergy, operator_.leftEnergy(), operator_.rightEnergy()});
    }
    way = arms_[0].pose().translation().x() - before;
    manager_.stop();
  }

  double way = 0;          ///< m, of the left hand
  double leastEnergy = 0;  ///< J

 private:
  void TestBody() override {}

  robots::Operator operator_;
};

/// The hand is behind where its muscles want it by the force that it feels over its stiffness.
TEST(GuideResistanceAtHands, HoldsThemBack) {
  const double numb = FeelingOperator(false).way;
  const FeelingOperator feeling(true);
  const double speed = OperatorParameters{}.crossover_frequency * FeelingOperator::kBeyond /
                       OperatorParameters{}.scale;
  const double behind = OperatorParameters{}.resistance * speed / HandModel{}.stiffness;
  EXPECT_NEAR(numb - feeling.way, behind, 0.2 * behind);
  EXPECT_GT(feeling.leastEnergy, -1e-3);
}

TEST(GuideResistanceAtHands, GivesNoEnergyByLateNews) {
  EXPECT_GT(FeelingOperator(true, 100ms).leastEnergy, -1e-3);
}

}  // namespace
}  // namespace robots::test
