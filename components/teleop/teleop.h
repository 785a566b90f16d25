#pragma once
// The teleoperation task: one master drives one slave.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/periodic_task.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "teleop/follow_law.h"
#include "teleop/teleoperation.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() TeleopParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// Slave metres a master metre.
  SUTURE_FIELD(range(0.01, 10)) double scale = 0.2;
  /// Data older than this are not acted on: following ends, and begins anew when they are fresh
  /// again.
  suture::Duration max_age = std::chrono::milliseconds(20);
  /// Prepare and follow without waiting for enable().
  bool enable_at_start = true;
};

/// Knows two Arm contracts and nothing of where the arms are. Follows only while both arms are
/// enabled, homed and not busy, and both arms' data are fresh; each time that becomes true, or it
/// was itself kept from looking for longer than max_age, it takes new anchors, so the slave never
/// jumps.
class SUTURE_COMPONENT() Teleop final : public suture::PeriodicTask, public Teleoperation {
 public:
  /// Throws suture::SetupError for a scale that is not above zero.
  explicit Teleop(const TeleopParameters& parameters);

  void enable() override;
  void disable() override;
  TeleopState teleop_state() const override { return state_; }
  FollowAnchors anchors() const override { return anchors_; }

  void run() override;
  /// Whoever connects hears the first state too.
  void onStart() override { teleoperation_.emit().teleop_state(state_); }

 private:
  void announce(const PoseStamped& master, const PoseStamped& slaveSetpoint);
  void leave();
  void enter(TeleopState state);

  const double scale_;
  const suture::Duration maxAge_;
  bool enableAtFirstCycle_;
  suture::Required<Arm> master_{*this, "Master"};
  suture::Required<Arm> slave_{*this, "Slave"};
  suture::Provided<Teleoperation> teleoperation_{*this, "Teleoperation", *this};

  ArmWatch masterWatch_{master_}, slaveWatch_{slave_};
  CycleWatch cycles_;
  TeleopState state_ = TeleopState::Disabled;
  FollowAnchors anchors_;
  std::optional<FollowLaw> law_;
};

}  // namespace robots
