#pragma once
// How simulated drives simulate their joints, as deployments choose it.

#include <suture/annotate.h>

#include <cstdint>

namespace robots {

enum class SUTURE_TYPE() DriveDynamics : std::uint8_t {
  Lag,        ///< joints without mass trail their goals by a time constant
  RigidBody,  ///< motors move bodies that have mass, against gravity, friction and stops
};

/// What can be chosen of joints with mass.
struct SUTURE_TYPE() RigidBodyOptions {
  /// Whether the motors carry the arm's weight beside what their controllers give.
  bool gravity_compensation = true;
  /// Whether encoders tell whole counts.
  bool quantisation = true;
  /// The standard deviation of what encoders add, in counts.
  SUTURE_FIELD(range(0, 1000)) double noise = 0;
  /// Equal seeds, goals and times give equal noise.
  std::uint32_t seed = 1;
  /// It says whether brakes hold the joints without power. The PSM and the MTM of the da Vinci
  /// Classic have none: what their motors carried sinks then.
  bool brakes = true;
  /// This is the share of each motor's current that sensors tell. Motors never give more than they
  /// can, so an over-current has to be planted: a sensor that tells too much is one to the arm.
  SUTURE_FIELD(range(0.1, 100)) double current_gain = 1;
};

}  // namespace robots
