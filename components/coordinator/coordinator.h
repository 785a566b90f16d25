#pragma once
// This is the component on whose permit all drives of a system depend.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>

#include <array>
#include <chrono>

#include "coordinator/emergency_stop.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() CoordinatorParameters {
  /// Is how often the permit is renewed, and how long a command to stop may wait.
  suture::Duration period = std::chrono::milliseconds(1);
};

/// Permits drives to have power until somebody presses the stop. It starts pressed, because one
/// that is started again does not know if it was pressed: an operator releases it. For the same
/// reason it is pressed when it goes on after a suspension, or after a pause in which the commands
/// of its clients may have been lost: a long one, or one in which a client's connection ended.
class SUTURE_COMPONENT() Coordinator final : public suture::PeriodicTask, public EmergencyStop {
 public:
  explicit Coordinator(const CoordinatorParameters& parameters);

  void press() override { set(true); }
  void release() override { set(false); }
  Permit permit() const override { return permit_; }

  void run() override;
  void onStart() override { begin(true); }
  void onRestart() override { begin(true); }
  void onResume() override { begin(false); }
  void onClient(const suture::ProvidedBase& interface, const suture::ConnectedClient& client,
                suture::ClientNews news) override;

 private:
  void begin(bool isStart);
  void set(bool pressed, bool isStart = false);

  CycleWatch cycles_;
  bool pressed_ = true;
  bool wasPressed_ = true;           // since the last permit
  bool clientIsGone_ = false;        // since the last cycle, and it came before the last pause
  suture::Time pauseCountsUntil_{};  // a client that goes until then may have pressed in a pause
  // They have come since the last pause; one for which there is no place counts as earlier.
  std::array<const suture::ConnectedClient*, 16> newcomers_{};
  Permit permit_;
  suture::Provided<EmergencyStop> stop_{*this, "Stop", *this};
};

}  // namespace robots
