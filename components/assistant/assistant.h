#pragma once
// This is a scripted bedside assistant, the hand at the emergency stop.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <optional>

#include "console/console.suture.h"
#include "coordinator/emergency_stop.suture.h"
#include "guidance/guidance.suture.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

struct SUTURE_TYPE() AssistantParameters {
  suture::Duration period = std::chrono::milliseconds(10);
  /// The assistant presses the stop this long after it has released the first one; 0 means never.
  suture::Duration press_after{};
  /// It releases what it has pressed this much later.
  suture::Duration release_after = std::chrono::seconds(1);
  /// It enables what has waited for its arms for this long since they lost their power, and brings
  /// up what has failed to come up for this reason, with power permitted. A person would look
  /// first. What stops within two seconds of such a loss has stopped by it.
  suture::Duration patience = std::chrono::milliseconds(500);
};

/// If the stop with which a coordinator starts is pressed when the assistant starts, it releases
/// that, once a console has said that no arm has been used before: else both may have been
/// restarted, and somebody may have pressed before. Without a console it does not know that, and
/// releases it. By the script it presses the stop once and releases it. It releases no stop that
/// somebody else has pressed later, and presses none that is pressed already.
///
/// Arms lose their power by a stop, or, as a console says, because their drives stopped by
/// themselves. After each loss the assistant once enables what waits for its arms because of it. If
/// the system goes down because of it before it was up, the assistant brings it up again. It leaves
/// alone what waits for another reason, such as an arm in FAULT, or an arm that somebody has
/// disabled or unhomed.
class SUTURE_COMPONENT() Assistant final : public suture::PeriodicTask {
 public:
  /// Throws suture::SetupError for a time that is not from 1 ms to a day; press_after may be 0.
  explicit Assistant(const AssistantParameters& parameters);

  void run() override;

 private:
  enum class Step : std::uint8_t { Begin, Watch, Pressed, Done };

  /// This is something that may wait for the assistant.
  struct Waiting {
    std::optional<suture::Time> since;  // none if it does not wait
    bool lostPower = false;             // so it waits
    bool asked = false;                 // since the last loss
  };

  void hear(const StopNews& news);
  void hear(const ConsoleState& state);
  void losePower();

  void followScript(suture::Time now);
  void enter(Step step, suture::Time now);
  void releaseStart(suture::Time now);
  /// Returns true if nobody can have pressed the stop with which the coordinator starts, neither
  /// that coordinator's nor an earlier one's; none while that is not known.
  std::optional<bool> isOfTheFirstStart();
  bool mayAskAgain(suture::Time now);
  template <class Contract>
  void attend(suture::Required<Contract>& one, Waiting& waiting, suture::Time now);
  void bringUpAgain(suture::Time now);
  bool isPressed() const { return stopNews_ && stopNews_->pressed; }
  bool isReleased() const { return stopNews_ && !stopNews_->pressed; }
  bool hasWaited(const Waiting& waiting, suture::Time now) const;
  void tell(Waiting& waiting, bool waits) const;

  const AssistantParameters parameters_;
  suture::Required<EmergencyStop> stop_{*this, "Stop"};
  SUTURE_REQUIRED(optional()) suture::Required<Console> console_{*this, "Console"};
  SUTURE_REQUIRED(optional()) suture::Required<Teleoperation> left_{*this, "Left"};
  SUTURE_REQUIRED(optional()) suture::Required<Teleoperation> right_{*this, "Right"};
  SUTURE_REQUIRED(optional()) suture::Required<Guidance> guidance_{*this, "Guidance"};

  Step step_ = Step::Begin;
  suture::Time stepped_;                     // when this step began
  suture::Time asked_;                       // when it last asked for what ends this step
  std::optional<StopNews> stopNews_;         // the last, of anybody; none before the first
  suture::Time released_;                    // when that was released last
  suture::Time lost_;                        // when power was lost last
  unsigned pressesHeard_ = 0;                // since it has pressed itself
  std::optional<std::uint64_t> firstPress_;  // of a coordinator that was the first
  SystemUse use_ = SystemUse::Unknown;
  bool isDown_ = false;  // the system
  bool wasUp_ = false;   // the system, at any time
  Waiting consoleWaits_, leftWaits_, rightWaits_, guidanceWaits_;
};

}  // namespace robots
