// An arm without friction and motors keeps its energy.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "dynamics/davinci_inertia.h"
#include "dynamics/joint_motion.h"
#include "kinematics/davinci.h"

namespace robots::dynamics::test {
namespace {

constexpr double kEnergyCycle = 1.0 / 1500;
constexpr int kEnergyCycles = 15'000;  // 10 s

template <int N>
JointMotion<N> frictionless(const kinematics::Chain<N>& chain, const ArmMechanics<N>& mechanics,
                            const typename JointMotion<N>::Joints& start) {
  using Joints = typename JointMotion<N>::Joints;
  const Joints never = Joints::Constant(std::numeric_limits<double>::infinity());
  return {ArmDynamics<N>(chain, mechanics.links),
          {.viscous = Joints::Zero(), .coulomb = Joints::Zero(), .lower = -never, .upper = never},
          start};
}

template <int N>
struct Energy {
  explicit Energy(const JointMotion<N>& motion) {
    const auto posture = motion.dynamics().at(motion.position());
    kinetic = motion.dynamics().kineticEnergy(posture, motion.velocity());
    potential = motion.dynamics().potentialEnergy(posture);
  }
  double total() const { return kinetic + potential; }

  double kinetic, potential;  // J
};

// The height that potential energy is counted from is arbitrary, so the error is told as a share of
// the most that was in motion.
template <int N>
void expectEnergyIsKept(JointMotion<N> motion) {
  const double before = Energy<N>(motion).total();
  double worst = 0, mostKinetic = 0;
  for (int i = 0; i < kEnergyCycles; ++i) {
    motion.advance(kEnergyCycle, JointMotion<N>::Joints::Zero());
    const Energy<N> energy(motion);
    worst = std::max(worst, std::abs(energy.total() - before));
    mostKinetic = std::max(mostKinetic, energy.kinetic);
  }
  ASSERT_GT(mostKinetic, 0.1) << "it hardly fell";
  EXPECT_LT(worst / mostKinetic, 1e-3);
}

TEST(Energy, IsConservedWhileThePsmFalls) {
  auto start = JointMotion<6>::Joints::Constant(0.3).eval();
  start[2] = 0.1;
  expectEnergyIsKept(frictionless(kinematics::psm(), psmMechanics(), start));
}

TEST(Energy, IsConservedWhileTheMtmFalls) {
  expectEnergyIsKept(frictionless(kinematics::mtmLeft(), mtmMechanics(), kinematics::mtmHome()));
}

}  // namespace
}  // namespace robots::dynamics::test
