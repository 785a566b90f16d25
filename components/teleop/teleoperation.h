#pragma once
// This is the contract of a teleoperation task, by which clients switch it, set it, and see what it
// is doing.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <cstdint>

namespace robots {

/// Says where following began: with this and the master's poses, anyone can compute what the slave
/// should do.
struct SUTURE_TYPE() FollowAnchors {
  /// The first master pose that was followed has this stamp.
  suture::Time master_stamp;
  /// The master's measured pose was this at that stamp, in the master's reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d master = Eigen::Isometry3d::Identity();
  /// The slave's set-point was this at entry, in the slave's reference frame.
  SUTURE_FIELD(unit("m")) Eigen::Isometry3d slave_setpoint = Eigen::Isometry3d::Identity();
  /// The slave moves this many metres for each metre of the master.
  double scale = 0;
  /// Following began this many times, including this one; 0 if it never did. A change of the
  /// settings counts too, and does not move the slave.
  std::uint64_t entry = 0;
  /// Rotates directions of the master's reference frame to those of the slave's that look the same
  /// to the surgeon.
  Eigen::Matrix3d view = Eigen::Matrix3d::Identity();
  bool rotation_locked = false;
  bool translation_locked = false;
};

enum class SUTURE_TYPE() TeleopState : std::uint8_t {
  Disabled,   ///< until enable()
  Preparing,  ///< waits for both arms: connected, enabled, homed, fresh data of both, and a slave
              ///< that carries out goals
  Following,
  Aligning,  ///< turns the master to the orientation that the slave has in the view
  Clutched,  ///< the clutch is pressed, or nobody is at the console: the slave holds, the master is
             ///< the surgeon's to move
};

/// Holds the settings by which the slave follows.
struct SUTURE_TYPE() TeleopSettings {
  /// The slave moves this many metres for each metre of the master.
  double scale = 0;
  bool rotation_locked = false;
  bool translation_locked = false;
};

/// Commands run in the teleoperation's own thread before its next cycle. A change of the settings
/// while it follows does not move the slave: it follows from where it is.
class SUTURE_INTERFACE() Teleoperation {
 public:
  virtual ~Teleoperation() = default;

  /// Enables and homes arms that are not, then follows. It does not enable an arm in FAULT: the
  /// operator who has removed the cause does.
  SUTURE_COMMAND() virtual void enable() = 0;
  /// Stops following. The slave holds.
  SUTURE_COMMAND() virtual void disable() = 0;

  SUTURE_COMMAND()
  virtual void set_scale(SUTURE_FIELD(range(0.01, 10)) double scale) = 0;
  /// Makes the slave keep its orientation. When it is unlocked, the master is aligned anew before
  /// the slave follows.
  SUTURE_COMMAND() virtual void lock_rotation(bool lock) = 0;
  /// Makes the slave keep its position.
  SUTURE_COMMAND() virtual void lock_translation(bool lock) = 0;

  SUTURE_COMMAND() virtual TeleopState teleop_state() const = 0;
  /// Returns the anchors of the present or last time of following.
  SUTURE_COMMAND() virtual FollowAnchors anchors() const = 0;
  SUTURE_COMMAND() virtual TeleopSettings settings() const = 0;

  SUTURE_EVENT(latched(), name("teleop_state")) suture::EventOf<TeleopState> teleop_state_event;
  /// Reports that following begins, or goes on with other settings.
  SUTURE_EVENT(latched()) suture::EventOf<FollowAnchors> followed;
  /// Reports each change, and the last one to a client that connects.
  SUTURE_EVENT(latched(), name("settings")) suture::EventOf<TeleopSettings> settings_event;
};

}  // namespace robots
