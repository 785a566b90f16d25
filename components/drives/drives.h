#pragma once
// The contract of an arm's joint drives: what closes the loops of its joints, and what gives them
// power. Research simulation, not a safety function: see README.md.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <array>
#include <cstdint>

#include "robot_types/joints.h"

namespace robots {

enum class SUTURE_TYPE() DrivePower : std::uint8_t {
  NotReady,  ///< since they started, nobody has permitted them power
  Stopped,   ///< by the emergency stop, or because nobody permits power any more
  Off,       ///< without power, which they are permitted to have: what brakes they have are on
  On,        ///< the joints follow their goals
};

/// The drives measure this in each of their cycles. It is of actuators, in the order of the joints
/// of the chain, and of the tool behind them: a slave's jaw, or a master's gripper, which nothing
/// drives. What the actuators of an arm are to its joints is in coupling.h; most are their joint.
/// One of a prismatic joint has m, m/s and N.
struct SUTURE_TYPE() DriveFeedback {
  /// The first `joints` entries count.
  SUTURE_FIELD(unit("rad")) std::array<double, kMaxJoints> position{};
  SUTURE_FIELD(unit("rad/s")) std::array<double, kMaxJoints> velocity{};
  std::uint32_t joints = 0;
  DrivePower power = DrivePower::NotReady;
  /// When they were last permitted to have power. Another moment than before: they have stopped
  /// meanwhile, or are others, which an arm may not have seen.
  suture::Time permitted;
  /// The drives' cycle.
  suture::Time stamp;
  /// What the motors give, as their currents tell.
  SUTURE_FIELD(unit("N.m")) std::array<double, kMaxJoints> effort{};
  /// Whether `effort` is measured. Joints that are simulated without mass need none, and tell 0; so
  /// does a simulated jaw, which has no mass whatever this says.
  bool measures_effort = false;
};

/// Where the actuators shall be, in the same order. What is there for a gripper counts for nothing.
struct SUTURE_TYPE() DriveGoal {
  /// The first `joints` entries count.
  SUTURE_FIELD(unit("rad")) std::array<double, kMaxJoints> position{};
  std::uint32_t joints = 0;
};

/// Commands run in the drives' own thread before its next cycle; the read is from the end of its
/// last one.
class SUTURE_INTERFACE() Drives {
 public:
  virtual ~Drives() = default;

  /// Releases the brakes; the joints hold where they are. `permitted` is that of the feedback that
  /// this answers: drives that have stopped since then, or may not have power, stay as they are.
  SUTURE_COMMAND() virtual void power_on(suture::Time permitted) = 0;
  /// The brakes hold the joints where they are; those of an arm that has none sink by their weight.
  SUTURE_COMMAND() virtual void power_off() = 0;
  /// Streams goals, newest wins. Without power, or with the wrong number of joints, one changes
  /// nothing. A stream that falls silent for 0.1 s leaves the joints where they are.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const DriveGoal& goal) = 0;

  SUTURE_COMMAND() virtual const DriveFeedback& feedback() const = 0;

  /// Each change, and the last one to whoever connects.
  SUTURE_EVENT(latched(), name("power")) suture::EventOf<DrivePower> power_event;
};

}  // namespace robots
