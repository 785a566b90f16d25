#pragma once
// This provides the contract Jaw on the arm that holds the instrument.

#include <suture/base/time.h>
#include <suture/component/channel/connected_client.h>
#include <suture/standard/message_draft.h>

#include <cstdint>
#include <optional>

#include "arm/jaw.h"
#include "arm_control/arm_controller.h"
#include "arm_control/motion/setpoint.h"
#include "arm_control/tool_state.h"
#include "arm_control/warnings.h"
#include "timing/stream_watch.h"

namespace robots {

struct JawModel {
  double lower, upper;        ///< rad
  double rate_limit;          ///< rad/s
  double acceleration_limit;  ///< rad/s2, of moves
  double effort_limit;        ///< N.m
};

/// Belongs to the arm's thread; only the constructor allocates.
class JawController final : public Jaw {
 public:
  /// `arm` holds the instrument, and must outlive this.
  JawController(const JawModel& model, const ArmController<6>& arm);

  const JointConfiguration& configuration_js() const override { return configuration_; }
  const JointState& measured_js() const override { return measuredJs_; }
  const JointState& setpoint_js() const override { return setpointJs_; }
  void servo_jp(const JointGoal& goal) override;
  void servo_jf(const JointEffortGoal& goal) override;
  void move_jp(const JointGoal& goal) override;

  /// Says that `client` is gone: if the jaw follows its stream, it holds and reports it.
  void clientGone(const suture::ConnectedClient& client);

  /// Executes one cycle at time `now`, after that of its arm. `drives` is none if the drives are
  /// silent.
  void step(suture::Time now, const std::optional<DriveReading<6>>& drives);
  /// Returns where the jaw shall be from this cycle on, in rad.
  double setpoint() const { return setpoint_.joints().value(); }

  /// Emits by `events` (what Provided<Jaw>::emit() returns) what happened since the last call.
  template <class Events>
  void announce(Events&& events) {
    if (moveEnded_) events.goal_reached(*moveEnded_);
    warnings_.forEachNew([&](ArmWarning reason) {
      events.warning(draft_.write(textOf(reason), static_cast<std::uint32_t>(reason), ++messages_));
    });
    moveEnded_.reset();
    warnings_.forgetNews();
  }

 private:
  using Joint = Setpoint<1>::Joints;
  enum class Activity { Holding, Following, Pushing, Moving };

  bool isEnabled() const { return arm_.operating_state().state == ArmState::Enabled; }
  bool mayMove();
  void begin(Activity activity);
  void endMove(bool reached);
  void hold();
  /// Moves the set-point as a stream asks for; `dt` is in s.
  void advance(double dt);
  void approach(double goal, double most);
  void take(const DriveReading<6>& drives);
  void publish(suture::Time now);

  const JawModel model_;
  const ArmController<6>& arm_;
  Activity activity_ = Activity::Holding;
  Setpoint<1> setpoint_;
  double goal_ = 0;    // rad, of servo_jp
  double effort_ = 0;  // N.m, of servo_jf
  suture::Time lastStep_;
  bool obeyed_ = false;  // in the cycle before
  StreamWatch stream_;
  const suture::ConnectedClient* streamer_ = nullptr;  // whose stream is followed
  bool limited_ = false;                               // the goal lies beyond a limit

  JointConfiguration configuration_;
  JointState measuredJs_, setpointJs_;
  std::optional<bool> moveEnded_;
  Warnings warnings_;
  suture::MessageDraft draft_;
  std::uint32_t messages_ = 0;  // how many have been emitted
};

}  // namespace robots
