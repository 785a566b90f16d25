#include "dynamics/joint_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace robots::dynamics {
namespace {

constexpr int kSweeps = 30;
constexpr double kSettled = 1e-13;  // rad/s or m/s: the iterations end once no sweep changes more

}  // namespace

template <int N>
JointMotion<N>::JointMotion(const ArmDynamics<N>& dynamics,
                            const JointSurroundings<N>& surroundings, const Joints& start)
    : dynamics_(dynamics),
      surroundings_(surroundings),
      position_(start.cwiseMax(surroundings.lower).cwiseMin(surroundings.upper)),
      velocity_(Joints::Zero()) {}

template <int N>
void JointMotion<N>::advance(double dt, const Joints& effort) {
  if (!(dt > 0)) return;
  const int steps = static_cast<int>(std::clamp(std::ceil(dt / kStep), 1.0, double{kMostSteps}));
  const double h = std::min(dt / steps, kStep);
  for (int i = 0; i < steps; ++i) step(h, effort);
}

template <int N>
void JointMotion<N>::halt() {
  velocity_.setZero();
  friction_.setZero();
}

template <int N>
void JointMotion<N>::step(double h, const Joints& effort) {
  const auto& [viscous, coulomb, lower, upper] = surroundings_;
  position_ = (position_ + h / 2 * velocity_).cwiseMax(lower).cwiseMin(upper);
  const auto posture = dynamics_.at(position_);
  Inertia damped = dynamics_.inertia(posture);
  damped.diagonal() += h * viscous;
  const Eigen::LLT<Inertia> factors(damped);
  const Joints driving = effort - viscous.cwiseProduct(velocity_);
  const auto change = [&](const Joints& velocity) -> Joints {
    return factors.solve(h * (driving - dynamics_.inverse(posture, velocity, Joints::Zero())));
  };
  const Joints middle = velocity_ + change(velocity_) / 2;
  velocity_ += change(middle);
  applyFrictionAndStops(h, factors.solve(Inertia::Identity()));
  position_ = (position_ + h / 2 * velocity_).cwiseMax(lower).cwiseMin(upper);
}

template <int N>
void JointMotion<N>::applyFrictionAndStops(double h, const Inertia& mobility) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const auto& [viscous, coulomb, lower, upper] = surroundings_;
  Joints least = -h * coulomb, most = h * coulomb;
  for (int i = 0; i < N; ++i) {
    if (position_[i] >= upper[i]) least[i] = -kAny;
    if (position_[i] <= lower[i]) most[i] = kAny;
  }
  Joints impulse = (h * friction_).cwiseMax(least).cwiseMin(most);
  velocity_ += mobility * impulse;
  double changed = kAny;
  for (int sweep = 0; sweep < kSweeps && changed > kSettled; ++sweep) {
    changed = 0;
    for (int i = 0; i < N; ++i) {
      const double wanted = impulse[i] - velocity_[i] / mobility(i, i);
      const double next = std::clamp(wanted, least[i], most[i]);
      const Joints difference = mobility.col(i) * (next - impulse[i]);
      velocity_ += difference;
      changed = std::max(changed, std::abs(difference[i]));
      impulse[i] = next;
    }
  }
  friction_ = impulse / h;
}

template class JointMotion<6>;
template class JointMotion<7>;

}  // namespace robots::dynamics
