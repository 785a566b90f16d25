#pragma once
// These are a surgeon's feet and head by a script.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>

#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"

namespace robots {

struct SUTURE_TYPE() ScriptedPedalsParameters {
  suture::Duration period = std::chrono::milliseconds(5);
  /// The clutch is pressed this long after the start, and released this much later; 0 means never.
  suture::Duration clutch_after{};
  suture::Duration clutch_for = std::chrono::seconds(1);
  /// The surgeon leaves the viewer this long after the start, and is back this much later; 0 means
  /// never.
  suture::Duration leave_after{};
  suture::Duration leave_for = std::chrono::seconds(1);
};

/// Stands for the pedals of a console and the sensor in its viewer. Nobody presses the other two
/// pedals.
class SUTURE_COMPONENT() ScriptedPedals final : public suture::PeriodicTask,
                                                public FootPedals,
                                                public OperatorPresence {
 public:
  /// Throws suture::SetupError for a time that is not from 1 ms to a day; what is `after` the start
  /// may be 0.
  explicit ScriptedPedals(const ScriptedPedalsParameters& parameters);

  PedalState pedals() const override { return pedals_; }
  Presence presence() const override { return presence_; }

  void run() override;
  void onStart() override;

 private:
  const ScriptedPedalsParameters parameters_;
  suture::Provided<FootPedals> pedalPort_{*this, "Pedals", *this};
  suture::Provided<OperatorPresence> presencePort_{*this, "Presence", *this};
  suture::Time start_;
  PedalState pedals_;
  Presence presence_{.present = true, .stamp = {}};
};

}  // namespace robots
