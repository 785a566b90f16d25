#pragma once
// This says how simulated drives simulate their joints, as deployments choose it.

#include <suture/annotate.h>

#include <cstdint>

namespace robots {

enum class SUTURE_TYPE() DriveDynamics : std::uint8_t {
  Lag,        ///< joints without mass trail their goals by a time constant
  RigidBody,  ///< motors move bodies that have mass, against gravity, friction and stops
};

/// Chooses the properties of joints with mass.
struct SUTURE_TYPE() RigidBodyOptions {
  /// If it is true, the motors carry the arm's weight beside what their controllers give, unless a
  /// goal asks them not to. If it is false, they never do.
  bool gravity_compensation = true;
  /// If it is true, encoders read whole counts.
  bool quantisation = true;
  /// The noise of encoders has this standard deviation, in counts.
  SUTURE_FIELD(range(0, 1000)) double noise = 0;
  /// Equal seeds, goals and times give equal noise.
  std::uint32_t seed = 1;
  /// If it is true, brakes hold the joints without power. The PSM and the MTM of the da Vinci
  /// Classic have none, so what their motors carried sinks then.
  bool brakes = true;
  /// Sensors measure this share of each motor's current. Motors never give more than they can, so a
  /// test must cause an over-current: a sensor that measures too much is one to the arm.
  SUTURE_FIELD(range(0.1, 100)) double current_gain = 1;
};

}  // namespace robots
