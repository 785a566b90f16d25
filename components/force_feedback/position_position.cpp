#include "force_feedback/position_position.h"

#include "parameters/parameter_check.h"

namespace robots {
namespace {

/// Returns the energy in J that the spring of the coupling holds along each axis: the hand may have
/// that back.
Eigen::Vector3d heldBySpring(const CouplingGains& gains, const TipMotion& master,
                             const TipMotion& slave) {
  return gains.stiffness / 2 * (slave.position - master.position).cwiseAbs2();
}

}  // namespace

PositionPosition::PositionPosition(const PositionPositionModel& model)
    : gains_(model.gains), port_(model.port) {
  ParameterCheck("position-position feedback")
      .isNotNegative("stiffness in N/m", gains_.stiffness)
      .isFinite("stiffness in N/m", gains_.stiffness)
      .isNotNegative("damping in N.s/m", gains_.damping)
      .isFinite("damping in N.s/m", gains_.damping);
}

Eigen::Vector3d PositionPosition::force(const TipMotion& master, const TipMotion& slave,
                                        double dt) {
  return port_.push(master, coupling(gains_, master, slave), heldBySpring(gains_, master, slave),
                    dt);
}

}  // namespace robots
