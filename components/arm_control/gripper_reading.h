#pragma once
// This provides the contract Gripper from what a master's drives measure.

#include <suture/base/time.h>

#include <optional>

#include "arm/gripper.h"
#include "arm_control/drive_reading.h"
#include "arm_control/tool_state.h"
#include "timing/seconds.h"

namespace robots {

struct GripperModel {
  double lower, upper;  ///< rad
  double closed;        ///< rad: at this angle or less it is closed
  double debounce;      ///< s: it is closed, or open, once it has been so for this long
};

/// Belongs to the master's thread; only the constructor allocates.
class GripperReading final : public Gripper {
 public:
  explicit GripperReading(const GripperModel& model)
      : model_(model),
        configuration_(toolConfiguration("gripper", model.lower, model.upper)),
        measuredJs_(blankToolState("gripper")) {
    measuredJs_.velocity.assign(1, 0);
  }

  const JointConfiguration& configuration_js() const override { return configuration_; }
  const JointState& measured_js() const override { return measuredJs_; }

  /// Executes one cycle at time `now`. `drives` is none if the drives are silent.
  void step(suture::Time now, const std::optional<DriveReading<7>>& drives) {
    measuredJs_.valid = drives.has_value();
    if (!drives) return;
    measuredJs_.position[0] = drives->tool.position;
    measuredJs_.velocity[0] = drives->tool.velocity;
    measuredJs_.stamp = drives->stamp;
    const bool isClosed = drives->tool.position <= model_.closed;
    if (isClosed != closed_) since_ = now;
    closed_ = isClosed;
    if (told_ != isClosed && secondsBetween(since_, now) >= model_.debounce)
      news_ = told_ = isClosed;
  }
  /// Returns what the drives are told, which has no effect because nothing drives a gripper.
  double setpoint() const { return measuredJs_.position[0]; }

  /// Emits by `events` (what Provided<Gripper>::emit() returns) what happened since the last call.
  template <class Events>
  void announce(Events&& events) {
    if (news_) events.closed(*news_);
    news_.reset();
  }

 private:
  const GripperModel model_;
  JointConfiguration configuration_;
  JointState measuredJs_;
  bool closed_ = false;
  suture::Time since_;        // when closed_ became so
  std::optional<bool> told_;  // what clients have been told
  std::optional<bool> news_;
};

}  // namespace robots
