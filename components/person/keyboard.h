#pragma once
// With this a person drives a master by the keys of a terminal.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include <chrono>
#include <string>

#include "arm/arm.suture.h"
#include "drives/gripper_hand.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "person/held_master.h"
#include "person/key_motion.h"
#include "person/terminal.h"
#include "teleop/teleoperation.suture.h"
#include "timing/cycle_watch.h"

namespace robots {

struct SUTURE_TYPE() KeyboardParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  SUTURE_FIELD(capacity(255)) std::string terminal = "/dev/tty";
  SUTURE_FIELD(unit("m/s"), range(0.001, 0.25)) double speed = 0.02;
  SUTURE_FIELD(unit("rad/s"), range(0.01, 2)) double turning_speed = 0.3;
  /// The gripper is this far open when it is not closed.
  SUTURE_FIELD(unit("rad"), range(0, 1.047)) double opening = 0.5;
  /// The motion ends this long after the last repeat of its key. If the terminal's first repeat
  /// comes later than this, the hand rests for a moment after the first press. It is 2 s at most.
  suture::Duration hold = std::chrono::milliseconds(150);
};

/// Moves the master as the keys say (KeyMotion), as long as HeldMaster lets it; its first status
/// says what each key does. A terminal that is gone ends the motion for good, which is reported as
/// an error; from then on its pedals are not fresh, so nobody teleoperates.
class SUTURE_COMPONENT() Keyboard final : public suture::PeriodicTask, public FootPedals {
 public:
  /// Throws suture::SetupError if it cannot have the terminal (terminal.h), or for a `hold` that is
  /// not from 1 ms to 2 s.
  explicit Keyboard(const KeyboardParameters& parameters);

  PedalState pedals() const override { return pedals_; }

  void run() override;
  void onStart() override;

 private:
  void readKeys(suture::Time now);
  void tellPedals(suture::Time now);

  suture::Required<Arm> master_{*this, "Master"};
  SUTURE_REQUIRED(optional())
  suture::Required<Teleoperation> teleoperation_{*this, "Teleoperation"};
  SUTURE_REQUIRED(optional()) suture::Required<GripperHand> hand_{*this, "Hand"};
  suture::Provided<FootPedals> pedalPort_{*this, "Pedals", *this};
  suture::MessagePort messages_{*this};
  HeldMaster held_;
  Terminal terminal_;
  KeyMotion keys_;
  CycleWatch cycles_;
  PedalState pedals_;
};

}  // namespace robots
