#include "force_feedback/position_position.h"

#include "parameters/parameter_check.h"

namespace robots {
namespace {

// The damping of a cycle takes away no more than this share of the momentum, because its force is
// held for the whole cycle, and would throw the hand back if it took more than all.
constexpr double kShare = 0.5;

/// Returns the energy in J that the spring of the coupling holds along each axis: the hand may have
/// that back.
Eigen::Vector3d heldBySpring(const CouplingGains& gains, const TipMotion& master,
                             const TipMotion& slave) {
  return gains.stiffness / 2 * (slave.position - master.position).cwiseAbs2();
}

}  // namespace

PositionPosition::PositionPosition(const PositionPositionModel& model) : model_(model) {
  const ParameterCheck check("position-position feedback");
  const auto judge = [&check](const char* parameter, double value) {
    check.isNotNegative(parameter, value).isFinite(parameter, value);
  };
  judge("stiffness in N/m", model.gains.stiffness);
  judge("damping in N.s/m", model.gains.damping);
  judge("greatest force in N", model.most_force);
  judge("mass in kg", model.mass);
}

Eigen::Vector3d PositionPosition::force(const TipMotion& master, const TipMotion& slave,
                                        double dt) {
  observer_.movedTo(master.position);
  const double most = model_.most_force;
  Eigen::Vector3d force = coupling(model_.gains, master, slave).cwiseMin(most).cwiseMax(-most);
  if (model_.passive) {
    observer_.keepAtMost(heldBySpring(model_.gains, master, slave));
    const double mostDamping = kShare * model_.mass / dt;
    force = damped(force, master.velocity, observer_.energy(), mostDamping, dt);
  }
  observer_.pushes(force);
  return force;
}

}  // namespace robots
