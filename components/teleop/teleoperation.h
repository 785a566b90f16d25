#pragma once
// The contract of a teleoperation task: switching it, and what it is doing.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <cstdint>

namespace robots {

/// Where following began: with it and the master's poses, anyone can compute what the slave should
/// do.
struct SUTURE_TYPE() FollowAnchors {
  /// Stamp of the first master pose that was followed.
  suture::Time master_stamp;
  /// The master's measured pose at that stamp, in the master's base frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d master = Eigen::Isometry3d::Identity();
  /// The slave's set-point at entry, in the slave's base frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d slave_setpoint = Eigen::Isometry3d::Identity();
  /// Slave metres a master metre.
  double scale = 0;
  /// How many times following began, this one included; 0: never.
  std::uint64_t entry = 0;
};

enum class SUTURE_TYPE() TeleopState : std::uint8_t {
  Disabled,   ///< until enable()
  Preparing,  ///< waits for both arms: connected, enabled, homed, and fresh data of both
  Following,
};

class SUTURE_INTERFACE() Teleoperation {
 public:
  virtual ~Teleoperation() = default;

  /// Enables and homes arms that are not, then follows.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops following; the slave holds.
  SUTURE_COMMAND() virtual void disable() = 0;

  SUTURE_COMMAND() virtual TeleopState teleop_state() const = 0;
  /// Of the present or last time of following.
  SUTURE_COMMAND() virtual FollowAnchors anchors() const = 0;

  SUTURE_EVENT(latched(), name("teleop_state")) suture::EventOf<TeleopState> teleop_state_event;
  /// Following begins.
  SUTURE_EVENT(latched()) suture::EventOf<FollowAnchors> followed;
};

}  // namespace robots
