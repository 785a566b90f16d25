#pragma once
// An arm of libfranka. Its errors and its time show none of their members; hooks say what they
// travel as.

#include <suture/annotate.h>

#include <franka/log.h>
#include <franka/vacuum_gripper_state.h>

#include <array>
#include <cstdint>

template <>
struct suture::Wire<franka::Errors> {
  using Type = std::array<bool, 41>;
  static Type to(const franka::Errors& errors);
  static franka::Errors from(const Type& flags) { return flags; }
};

template <>
struct suture::Wire<franka::Duration> {
  using Type = std::uint64_t;
  static Type to(const franka::Duration& duration) { return duration.toMSec(); }
  static franka::Duration from(Type milliseconds) { return franka::Duration(milliseconds); }
};

/// The tool's torques. No constructor makes them of nothing.
template <>
struct suture::Wire<franka::Torques> {
  using Type = std::array<double, 7>;
  static Type to(const franka::Torques& torques) { return torques.tau_J; }
  static franka::Torques from(const Type& torques) { return torques; }
};

namespace lab {

SUTURE_EXTERNAL_TYPE(franka::RobotMode);
SUTURE_EXTERNAL_TYPE(franka::VacuumGripperDeviceStatus);
SUTURE_EXTERNAL_TYPE(franka::VacuumGripperState);
SUTURE_EXTERNAL_TYPE(franka::RobotState, all(), member(m_ee, unit("kg"), range(0, 20)),
                     member(q, unit("rad")), member(dq, unit("rad/s")), member(tau_J, unit("N.m")));
SUTURE_EXTERNAL_TYPE(franka::RobotCommand, torques);
SUTURE_EXTERNAL_TYPE(franka::Record);

/// An arm, as its own control loop sees it.
class SUTURE_INTERFACE() FrankaArm {
 public:
  virtual ~FrankaArm() = default;
  SUTURE_COMMAND(latest()) virtual void command(const franka::RobotCommand& command) = 0;
  SUTURE_COMMAND() virtual const franka::RobotState& state() const = 0;
  SUTURE_COMMAND() virtual franka::RobotMode mode() const = 0;
  SUTURE_COMMAND() virtual const franka::VacuumGripperState& gripper() const = 0;
  SUTURE_EVENT(queue(4)) suture::EventOf<franka::Record> stopped;
};

}  // namespace lab
