#pragma once
// This is the contract of an arm's joint drives, which close the loops of its joints and give them
// power. This is a research simulation, not a safety function: see README.md.

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

/// A DriveFeedback is what the drives measure in each of their cycles. It is of actuators, in the
/// order of the joints of the chain, and of the tool behind them: a slave's jaw, or a master's
/// gripper, which nothing drives. coupling.h says how the actuators of an arm turn its joints; most
/// are their joint. The actuator of a prismatic joint has m, m/s and N.
struct SUTURE_TYPE() DriveFeedback {
  /// The first `joints` entries count.
  SUTURE_FIELD(unit("rad")) std::array<double, kMaxJoints> position{};
  SUTURE_FIELD(unit("rad/s")) std::array<double, kMaxJoints> velocity{};
  std::uint32_t joints = 0;
  DrivePower power = DrivePower::NotReady;
  /// They were last permitted to have power at this time. If this changes, they have stopped
  /// meanwhile, or are other drives, which an arm may not have seen.
  suture::Time permitted;
  /// The stamp is that of the drives' cycle.
  suture::Time stamp;
  /// The motors give these efforts, as their currents show them.
  SUTURE_FIELD(unit("N.m")) std::array<double, kMaxJoints> effort{};
  /// This is true if `effort` is measured. Joints that are simulated without mass need none, and
  /// have 0; so does a simulated jaw, which has no mass whatever this says.
  bool measures_effort = false;
  /// This is true if the drives obey what a goal says beside positions. Joints that are simulated
  /// without mass have no effort, so their drives follow positions only.
  bool controls_effort = false;
};

/// Says where the actuators shall be, in the same order, and what their motors do beside that. The
/// entry of a gripper has no effect.
struct SUTURE_TYPE() DriveGoal {
  /// The first `joints` entries count.
  SUTURE_FIELD(unit("rad")) std::array<double, kMaxJoints> position{};
  std::uint32_t joints = 0;
  /// The motors give this beside what holds the joints and carries the arm. All together is cut to
  /// what a motor can give.
  SUTURE_FIELD(unit("N.m")) std::array<double, kMaxJoints> effort{};
  /// There is an entry for each joint of the chain, not for each actuator. A joint for which it is
  /// true is not held: its position here has no effect. At more than its rate limit it is slowed
  /// down.
  std::array<bool, kMaxJoints> released{};
  /// If it is true, the motors carry the arm's weight. It counts until the next goal, also after
  /// the stream has ended.
  bool gravity_compensation = true;
};

/// Commands run in the drives' own thread before its next cycle; the read is from the end of its
/// last one.
class SUTURE_INTERFACE() Drives {
 public:
  virtual ~Drives() = default;

  /// Releases the brakes. The joints hold where they are. `permitted` is that of the feedback that
  /// this answers: drives that have stopped since then, or may not have power, stay as they are.
  SUTURE_COMMAND() virtual void power_on(suture::Time permitted) = 0;
  /// Lets the brakes hold the joints where they are. The joints of an arm that has none sink by
  /// their weight.
  SUTURE_COMMAND() virtual void power_off() = 0;
  /// Streams goals, newest wins. Without power, or with the wrong number of joints, a goal changes
  /// nothing. A stream that falls silent for 0.1 s leaves the joints where they are: they are held
  /// there, and no effort of a goal acts any more.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void servo_jp(const DriveGoal& goal) = 0;

  SUTURE_COMMAND() virtual const DriveFeedback& feedback() const = 0;

  /// Reports each change, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("power")) suture::EventOf<DrivePower> power_event;
};

}  // namespace robots
