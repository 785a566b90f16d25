#pragma once
// The contract of a teleoperation task: switching it, setting it, and what it is doing.

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
  /// The master's measured pose at that stamp, in the master's reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d master = Eigen::Isometry3d::Identity();
  /// The slave's set-point at entry, in the slave's reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d slave_setpoint = Eigen::Isometry3d::Identity();
  /// Slave metres a master metre.
  double scale = 0;
  /// How many times following began, this one included; 0: never. A change of what it follows by
  /// counts too, and does not move the slave.
  std::uint64_t entry = 0;
  /// From directions of the master's reference frame to those of the slave's that look the same to
  /// the surgeon.
  Eigen::Matrix3d view = Eigen::Matrix3d::Identity();
  bool rotation_locked = false;
  bool translation_locked = false;
};

enum class SUTURE_TYPE() TeleopState : std::uint8_t {
  Disabled,   ///< until enable()
  Preparing,  ///< waits for both arms: connected, enabled, homed, and fresh data of both
  Following,
  Aligning,  ///< turns the master to the orientation that the slave has in the view
  Clutched,  ///< the clutch is pressed, or nobody is at the console: the slave holds, the master is
             ///< the surgeon's to move
};

/// What the slave follows by.
struct SUTURE_TYPE() TeleopSettings {
  /// Slave metres a master metre.
  double scale = 0;
  bool rotation_locked = false;
  bool translation_locked = false;
};

/// Commands run in the teleoperation's own thread before its next cycle. A change of the settings
/// while it follows does not move the slave: it follows from where it is.
class SUTURE_INTERFACE() Teleoperation {
 public:
  virtual ~Teleoperation() = default;

  /// Enables and homes arms that are not, then follows. An arm in FAULT is not enabled: whoever has
  /// removed the cause enables it.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops following; the slave holds.
  SUTURE_COMMAND() virtual void disable() = 0;

  SUTURE_COMMAND()
  virtual void set_scale(SUTURE_FIELD(range(0.01, 10)) double scale) = 0;
  /// The slave keeps its orientation. Unlocked, the master is aligned anew before following.
  SUTURE_COMMAND() virtual void lock_rotation(bool lock) = 0;
  /// The slave keeps its position.
  SUTURE_COMMAND() virtual void lock_translation(bool lock) = 0;

  SUTURE_COMMAND() virtual TeleopState teleop_state() const = 0;
  /// The anchors of the present or last time of following.
  SUTURE_COMMAND() virtual FollowAnchors anchors() const = 0;
  SUTURE_COMMAND() virtual TeleopSettings settings() const = 0;

  SUTURE_EVENT(latched(), name("teleop_state")) suture::EventOf<TeleopState> teleop_state_event;
  /// Following begins, or goes on by other settings.
  SUTURE_EVENT(latched()) suture::EventOf<FollowAnchors> followed;
  /// Each change, and the last one to whoever connects.
  SUTURE_EVENT(latched(), name("settings")) suture::EventOf<TeleopSettings> settings_event;
};

}  // namespace robots
