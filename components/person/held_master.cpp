#include "person/held_master.h"

#include <chrono>
#include <utility>

#include "arm/fresh_pose.h"
#include "person/hand_goal.h"
#include "surgeon/pause.h"
#include "timing/seconds.h"

namespace robots {
namespace {

constexpr suture::Duration kOldestSetpoint = std::chrono::milliseconds(20);

}  // namespace

HeldMaster::HeldMaster(suture::Required<Arm>& master,
                       suture::Required<Teleoperation>& teleoperation,
                       suture::Required<GripperHand>& hand, double opening)
    : master_(master),
      teleoperation_(teleoperation),
      hand_(hand),
      opening_(opening),
      watch_(master) {
  teleoperation_.on().teleop_state([this](const TeleopState& state) {
    mayBeMoved_ = state == TeleopState::Following || state == TeleopState::Clutched;
  });
}

bool HeldMaster::mayMove() {
  const bool may = teleoperation_.isAbsent() || (teleoperation_.connected() && mayBeMoved_);
  return may && watch_.ready() && master_.connected();
}

void HeldMaster::move(const HandInput& input) {
  const suture::Time now = suture::now();
  const double dt = secondsBetween(std::exchange(last_, now), now);
  const bool missed = cycles_.missed(kLongestPause);
  if (watch_.hasBrokenOff()) goal_.reset();
  const auto setpoint = master_.setpoint_cp();
  const PoseStamped* const fresh = freshPose(setpoint, kOldestSetpoint);
  if (missed || !mayMove() || fresh == nullptr) return letGo();
  if (input.isAtRest()) {
    hasRested_ = true;
    goal_.reset();
  } else if (hasRested_) {
    lead(input, fresh->pose, dt);
  }
  if (hasRested_ && input.opening) (void)hand_.squeeze(opening_ * *input.opening);
}

void HeldMaster::letGo() {
  goal_.reset();
  hasRested_ = false;
}

void HeldMaster::lead(const HandInput& input, const Eigen::Isometry3d& setpoint, double dt) {
  goal_ = movedGoal(goal_.value_or(setpoint), setpoint, input, dt);
  if (!master_.servo_cp({*goal_, suture::now(), true})) goal_.reset();
}

}  // namespace robots
