// These tests compare the room that joints leave a tip with the arm's own inverse kinematics.

#include "guidance/joint_room.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <random>

#include "kinematics/davinci.h"
#include "kinematics/psm_inverse.h"

namespace robots {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Room has a PSM somewhere, whose joints are far from all limits.
class Room : public testing::Test {
 protected:
  TipJoints anywhere() {
    TipJoints q;
    q << any(), 0.7 * any(), 0.12 + 0.05 * any(), 2 * any(), any(), any();
    return q;
  }
  double any() { return uniform_(random_); }
  Vector3d anyOf(double size) { return size * Vector3d(any(), any(), any()); }

  void stand(const TipJoints& q) {
    setpoint_.position.assign(q.data(), q.data() + kTipJoints);
    const kinematics::Chain<kTipJoints>::Jacobian jacobian = chain_.jacobian(q);
    jacobian_.coefficients.assign(jacobian.data(), jacobian.data() + jacobian.size());
  }

  const kinematics::Chain<kTipJoints> chain_ = kinematics::psm();
  JointState setpoint_;
  Jacobian jacobian_;

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST_F(Room, EndsAtTheJointLimits) {
  constexpr double kLeft = 0.02;  // rad or m: what a joint may go after the step
  for (int i = 0; i < 1000; ++i) {
    const TipJoints q = anywhere();
    stand(q);
    const TipAhead ahead{.moved = anyOf(2e-4), .turned = anyOf(2e-3), .turns = Vector3d::Zero()};
    const Eigen::Matrix3d base =
        Eigen::AngleAxisd(3 * any(), anyOf(1).normalized()).toRotationMatrix();
    const Vector3d step = anyOf(2e-4);
    Eigen::Isometry3d goal = chain_.forward(q);
    goal.translation() += ahead.moved + base.transpose() * step;
    goal.linear() =
        Eigen::AngleAxisd(ahead.turned.norm(), ahead.turned.normalized()) * goal.linear();
    const auto there = kinematics::psmInverse(chain_, goal, q);
    ASSERT_TRUE(there.found);
    const JointBounds bounds{there.q.array() - kLeft, there.q.array() + 2 * kLeft,
                             TipJoints::Constant(kInfinity)};
    const JointRoom room = jointRoom(bounds, setpoint_, jacobian_, ahead, base, 0.001);
    const TipJoints moved = room.motion * step;
    EXPECT_TRUE((moved - room.least).isApproxToConstant(kLeft, 0.02))
        << (moved - room.least).transpose();
    EXPECT_TRUE((room.most - moved).isApproxToConstant(2 * kLeft, 0.02))
        << (room.most - moved).transpose();
  }
}

TEST_F(Room, TheFirstJointTurnsTheTool) {
  for (int i = 0; i < 1000; ++i) {
    const TipJoints q = anywhere();
    stand(q);
    const Vector3d turn = anyOf(2e-3);
    const TipAhead ahead{.moved = Vector3d::Zero(), .turned = turn, .turns = turn};
    Eigen::Isometry3d goal = chain_.forward(q);
    goal.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * goal.linear();
    const auto there = kinematics::psmInverse(chain_, goal, q);
    ASSERT_TRUE(there.found);
    const double farthest = (there.q - q).cwiseAbs().maxCoeff();
    const auto share = [&](double room) {
      const JointBounds bounds{q.array() - room, q.array() + room, TipJoints::Constant(kInfinity)};
      return turnShare(bounds, setpoint_, jacobian_, ahead, 0.001);
    };
    EXPECT_NEAR(share(farthest / 2), 0.5, 0.02);
    EXPECT_EQ(share(0), 0);
    EXPECT_EQ(share(2 * farthest), 1);
  }
}

TEST_F(Room, TurnsTheToolAtAJointsRate) {
  stand(anywhere());
  const TipAhead ahead{Vector3d::Zero(), {0, 0, 2e-3}, {0, 0, 2e-3}};
  const auto share = [&](double rate) {
    const TipJoints far = TipJoints::Constant(10);
    return turnShare({-far, far, TipJoints::Constant(rate)}, setpoint_, jacobian_, ahead, 0.001);
  };
  EXPECT_EQ(share(100), 1);
  EXPECT_LT(share(0.1), 1);
  EXPECT_NEAR(share(0.05), share(0.1) / 2, 1e-9);
}

TEST_F(Room, LetsAJointReturnFromBeyond) {
  const TipJoints q = anywhere();
  stand(q);
  const TipAhead ahead{Vector3d::Zero(), {0, 0, 2e-3}, {0, 0, 2e-3}};
  const TipAhead back{Vector3d::Zero(), -ahead.turned, -ahead.turns};
  const TipJoints far = TipJoints::Constant(10), fast = TipJoints::Constant(kInfinity);
  for (int joint = 0; joint < kTipJoints; ++joint) {
    JointBounds bounds{-far, far, fast};
    bounds.upper[joint] = q[joint] - 0.01;
    const double one = turnShare(bounds, setpoint_, jacobian_, ahead, 0.001);
    const double other = turnShare(bounds, setpoint_, jacobian_, back, 0.001);
    EXPECT_EQ(std::max(one, other), 1) << joint;
  }
}

TEST_F(Room, AFastJointGetsTheRest) {
  stand(anywhere());
  const JointBounds bounds{TipJoints::Constant(-10), TipJoints::Constant(10),
                           TipJoints::Constant(2)};
  TipAhead ahead{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  const JointRoom still =
      jointRoom(bounds, setpoint_, jacobian_, ahead, Eigen::Matrix3d::Identity(), 0.001);
  EXPECT_TRUE(still.most.isApproxToConstant(0.002));
  EXPECT_TRUE(still.least.isApproxToConstant(-0.002));
  ahead.turned = ahead.turns = {1e-4, 0, 2e-4};
  const JointRoom turning =
      jointRoom(bounds, setpoint_, jacobian_, ahead, Eigen::Matrix3d::Identity(), 0.001);
  EXPECT_GT((turning.most - still.most).norm(), 1e-5);
  EXPECT_TRUE((turning.most - turning.least).isApproxToConstant(0.004));
}

TEST(JointBounds, AreInfiniteWhereAnArmSaysNone) {
  JointConfiguration said;
  said.name.resize(6);
  said.position_min.assign(6, -1);
  said.velocity_min.assign(6, -3);
  said.velocity_max.assign(6, 2);
  const auto bounds = jointBounds(said);
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->lower[5], -1);
  EXPECT_EQ(bounds->upper[5], kInfinity);
  EXPECT_EQ(bounds->rate[5], 2);
}

TEST(JointBounds, ASevenJointArmHasNone) {
  JointConfiguration said;
  said.name.resize(7);
  EXPECT_FALSE(jointBounds(said));
}

}  // namespace
}  // namespace robots
