#pragma once
// These are joint vectors. Units are those of a revolute joint; a prismatic joint has m, m/s and N
// in their place.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace robots {

/// An arm has at most this many joints here.
constexpr std::uint32_t kMaxJoints = 8;

/// A JointState is the state of all joints of an arm, in chain order: CRTK's measured_js and
/// setpoint_js. A list is empty if its quantity is not known, and as long as `name` otherwise.
struct SUTURE_TYPE() JointState {
  SUTURE_FIELD(capacity(8, 15)) std::vector<std::string> name;
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position;
  SUTURE_FIELD(capacity(8), unit("rad/s")) std::vector<double> velocity;
  SUTURE_FIELD(capacity(8), unit("N.m")) std::vector<double> effort;
  suture::Time stamp;
  /// If it is false, do not use the state.
  bool valid = false;
};

/// Says where joints shall go: CRTK's servo_jp and move_jp.
struct SUTURE_TYPE() JointGoal {
  /// There is one entry for each joint, in chain order.
  SUTURE_FIELD(capacity(8), unit("rad")) std::vector<double> position;
  suture::Time stamp;
};

/// A JointSolution is a joint vector that an arm computed, without heap so that a control loop may
/// return it.
struct SUTURE_TYPE() JointSolution {
  /// The first `joints` entries count.
  SUTURE_FIELD(unit("rad")) std::array<double, kMaxJoints> position{};
  std::uint32_t joints = 0;
  /// If it is false, no joint vector within limits reaches the pose, and `position` is the nearest
  /// one found.
  bool found = false;
};

}  // namespace robots
