// These compare the equations of motion of both arms with KDL.

#include "dynamics/arm_dynamics.h"

#include <gtest/gtest.h>

#include "dynamics/davinci_inertia.h"
#include "kinematics/davinci.h"
#include "unit/dynamics/kdl_inertia.h"

namespace robots::dynamics::test {
namespace {

using kinematics::test::randomJoints;
using kinematics::test::toKdl;

constexpr int kStates = 10'000;
constexpr double kTolerance = 1e-9;
// None of its components is zero, so that none of them can be wrong unseen.
const Eigen::Vector3d kTiltedGravity{1.1, -2.3, -9.4};

template <int N>
typename ArmDynamics<N>::Joints randomRates(double most, std::mt19937& random) {
  std::uniform_real_distribution<double> rate(-most, most);
  typename ArmDynamics<N>::Joints rates;
  for (int i = 0; i < N; ++i) rates[i] = rate(random);
  return rates;
}

template <int N>
struct Arm {
  Arm(const kinematics::Chain<N>& chain, const KDL::Chain& kdl,
      const typename ArmDynamics<N>::Links& links)
      : dynamics(chain, links, kTiltedGravity), oracle(withBodies<N>(kdl, links)) {}

  ArmDynamics<N> dynamics;
  KDL::Chain oracle;
};

Arm<6> psm() { return {kinematics::psm(), kinematics::test::kdlPsm(), psmMechanics().links}; }
Arm<7> leftMtm() {
  return {kinematics::mtmLeft(), kinematics::test::kdlMtm(), mtmMechanics().links};
}
Arm<7> rightMtm() {
  return {kinematics::mtmRight(), kinematics::test::kdlMtm(), mtmMechanics().links};
}

template <int N>
void expectInverseOfKdl(const Arm<N>& arm) {
  std::mt19937 random(1);
  KDL::ChainIdSolver_RNE solver(arm.oracle, kdlVector(kTiltedGravity));
  KDL::JntArray efforts(N);
  for (int state = 0; state < kStates; ++state) {
    const auto q = randomJoints(arm.dynamics.chain(), random);
    const auto velocity = randomRates<N>(5, random), acceleration = randomRates<N>(50, random);
    ASSERT_EQ(solver.CartToJnt(toKdl(q), toKdl(velocity), toKdl(acceleration),
                               KDL::Wrenches(arm.oracle.getNrOfSegments()), efforts),
              0);
    const auto ours = arm.dynamics.inverse(arm.dynamics.at(q), velocity, acceleration);
    ASSERT_LT((ours - efforts.data).cwiseAbs().maxCoeff(), kTolerance) << q.transpose();
  }
}

TEST(InverseDynamics, AgreesWithKdlForThePsm) { expectInverseOfKdl(psm()); }
TEST(InverseDynamics, AgreesWithKdlForTheLeftMtm) { expectInverseOfKdl(leftMtm()); }
TEST(InverseDynamics, AgreesWithKdlForTheRightMtm) { expectInverseOfKdl(rightMtm()); }

template <int N>
void expectMatricesOfKdl(const Arm<N>& arm) {
  std::mt19937 random(2);
  KDL::ChainDynParam solver(arm.oracle, kdlVector(kTiltedGravity));
  KDL::JntSpaceInertiaMatrix inertia(N);
  KDL::JntArray gravity(N), coriolis(N);
  for (int state = 0; state < kStates; ++state) {
    const auto q = randomJoints(arm.dynamics.chain(), random);
    const auto velocity = randomRates<N>(5, random);
    solver.JntToMass(toKdl(q), inertia);
    solver.JntToGravity(toKdl(q), gravity);
    solver.JntToCoriolis(toKdl(q), toKdl(velocity), coriolis);
    const auto posture = arm.dynamics.at(q);
    ASSERT_LT((arm.dynamics.inertia(posture) - inertia.data).cwiseAbs().maxCoeff(), kTolerance);
    ASSERT_LT((arm.dynamics.gravity(posture) - gravity.data).cwiseAbs().maxCoeff(), kTolerance);
    const auto bias = arm.dynamics.inverse(posture, velocity, ArmDynamics<N>::Joints::Zero());
    ASSERT_LT((bias - gravity.data - coriolis.data).cwiseAbs().maxCoeff(), kTolerance);
  }
}

TEST(InertiaMatrix, AgreesWithKdlForThePsm) { expectMatricesOfKdl(psm()); }
TEST(InertiaMatrix, AgreesWithKdlForTheLeftMtm) { expectMatricesOfKdl(leftMtm()); }
TEST(InertiaMatrix, AgreesWithKdlForTheRightMtm) { expectMatricesOfKdl(rightMtm()); }

template <int N>
void expectForwardUndoesInverse(const Arm<N>& arm) {
  std::mt19937 random(3);
  for (int state = 0; state < kStates; ++state) {
    const auto posture = arm.dynamics.at(randomJoints(arm.dynamics.chain(), random));
    const auto velocity = randomRates<N>(5, random), acceleration = randomRates<N>(50, random);
    const auto effort = arm.dynamics.inverse(posture, velocity, acceleration);
    const auto again = arm.dynamics.forward(posture, velocity, effort);
    ASSERT_LT((again - acceleration).cwiseAbs().maxCoeff(), kTolerance);
  }
}

TEST(ForwardDynamics, UndoesTheInverseForThePsm) { expectForwardUndoesInverse(psm()); }
TEST(ForwardDynamics, UndoesTheInverseForTheMtm) { expectForwardUndoesInverse(leftMtm()); }

// The effort that holds an arm is the slope of its potential energy along each joint.
template <int N>
void expectGravityIsTheSlopeOfPotentialEnergy(const Arm<N>& arm) {
  constexpr double kStep = 1e-5;
  std::mt19937 random(4);
  for (int state = 0; state < 1000; ++state) {
    const auto q = randomJoints(arm.dynamics.chain(), random);
    const auto gravity = arm.dynamics.gravity(arm.dynamics.at(q));
    for (int i = 0; i < N; ++i) {
      const auto step = (ArmDynamics<N>::Joints::Unit(i) * kStep).eval();
      const double above = arm.dynamics.potentialEnergy(arm.dynamics.at(q + step));
      const double below = arm.dynamics.potentialEnergy(arm.dynamics.at(q - step));
      ASSERT_NEAR(gravity[i], (above - below) / (2 * kStep), 1e-8);
    }
  }
}

TEST(PotentialEnergy, ChangesByThePsmsHoldingEffort) {
  expectGravityIsTheSlopeOfPotentialEnergy(psm());
}
TEST(PotentialEnergy, ChangesByTheMtmsHoldingEffort) {
  expectGravityIsTheSlopeOfPotentialEnergy(leftMtm());
}

}  // namespace
}  // namespace robots::dynamics::test
