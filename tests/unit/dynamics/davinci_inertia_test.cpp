// The figures of the da Vinci arms are possible: they describe bodies that exist, and motors that
// can hold them.

#include "dynamics/davinci_inertia.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "drives/coupling.h"
#include "kinematics/davinci.h"
#include "unit/kinematics/kdl_oracle.h"

namespace robots::dynamics::test {
namespace {

template <int N>
void expectBodiesThatExist(const ArmMechanics<N>& arm) {
  for (const LinkInertia& link : arm.links) {
    EXPECT_GT(link.mass, 0);
    EXPECT_GT(link.rotor, 0);
    EXPECT_EQ(link.inertia, link.inertia.transpose());
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(link.inertia).eigenvalues();
    EXPECT_GT(principal[0], 0);
    EXPECT_LE(principal[2], principal[0] + principal[1]) << "no body has such an inertia";
  }
  EXPECT_GT(arm.viscous.minCoeff(), 0);
  EXPECT_GT(arm.coulomb.minCoeff(), 0);
  EXPECT_GT(arm.encoder_step.minCoeff(), 0);
}

TEST(DaVinciInertia, ThePsmHasPossibleBodies) { expectBodiesThatExist(psmMechanics()); }
TEST(DaVinciInertia, TheMtmHasPossibleBodies) { expectBodiesThatExist(mtmMechanics()); }

template <int N>
void expectMotorsHoldIt(const kinematics::Chain<N>& chain, const ArmMechanics<N>& arm,
                        const Coupling<N>& coupling = {}) {
  const ArmDynamics<N> dynamics(chain, arm.links);
  std::mt19937 random(5);
  auto most = ArmDynamics<N>::Joints::Zero().eval();
  for (int sample = 0; sample < 10'000; ++sample) {
    const auto q = kinematics::test::randomJoints(chain, random);
    most = most.cwiseMax(coupling.actuatorEfforts(dynamics.gravity(dynamics.at(q))).cwiseAbs());
  }
  for (int i = 0; i < N; ++i) EXPECT_LT(most[i], arm.motor_limit[i]) << "motor " << i;
}

TEST(DaVinciInertia, LetsMotorsHoldThePsmAnywhere) {
  expectMotorsHoldIt(kinematics::psm(), psmMechanics());
}
TEST(DaVinciInertia, LetsMotorsHoldTheMtmAnywhere) {
  expectMotorsHoldIt(kinematics::mtmLeft(), mtmMechanics(), mtmCoupling());
  expectMotorsHoldIt(kinematics::mtmRight(), mtmMechanics(), mtmCoupling());
}

// The carriage and its counterweight are as heavy together as apart (README.md), and weigh on the
// insertion as their difference.
TEST(DaVinciInertia, HasTheInsertionsCounterweight) {
  const auto chain = kinematics::psm();
  const ArmDynamics<6> dynamics(chain, psmMechanics().links);
  const auto posture = dynamics.at(ArmDynamics<6>::Joints::Zero());
  const double motor = 1e-6 * 336.6 * 336.6, instrument = 0.050 + 0.003 + 0.004;
  EXPECT_NEAR(dynamics.inertia(posture)(2, 2), 0.363 + 0.350 + instrument + motor, 1e-12);
  EXPECT_NEAR(dynamics.gravity(posture)[2], -9.80665 * (0.363 - 0.350 + instrument), 1e-12);
}

}  // namespace
}  // namespace robots::dynamics::test
