#pragma once
// The component that all drives of a system live by.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/periodic_task.h>
#include <suture/component/provided.h>

#include <chrono>

#include "coordinator/emergency_stop.suture.h"

namespace robots {

struct SUTURE_TYPE() CoordinatorParameters {
  /// How often the permit is renewed, and how long a command to stop may wait.
  suture::Duration period = std::chrono::milliseconds(1);
};

/// Permits drives to have power until somebody presses the stop. Starts released: no drive has
/// power before an arm is enabled.
class SUTURE_COMPONENT() Coordinator final : public suture::PeriodicTask, public EmergencyStop {
 public:
  explicit Coordinator(const CoordinatorParameters& parameters);

  void press() override { set(true); }
  void release() override { set(false); }
  Permit permit() const override { return permit_; }

  void run() override;

 private:
  void set(bool pressed);

  bool pressed_ = false;
  Permit permit_;
  suture::Provided<EmergencyStop> stop_{*this, "Stop", *this};
};

}  // namespace robots
