#pragma once
// With this a person drives a master by a gamepad.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "arm/arm.suture.h"
#include "drives/gripper_hand.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "person/axis_range.h"
#include "person/event_file.h"
#include "person/gamepad_decoder.h"
#include "person/held_master.h"
#include "teleop/teleoperation.suture.h"

namespace robots {

struct SUTURE_TYPE() GamepadParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  /// The file is an input device, or a FIFO of its events. A name below /dev/input/by-id stays the
  /// same when others are plugged in.
  SUTURE_FIELD(capacity(255)) std::string file = "/dev/input/event0";
  AxisRange stick{.lowest = -32768, .highest = 32767};
  AxisRange trigger{.lowest = 0, .highest = 255};
  /// A stick is at rest within this share of the way from its middle to its end.
  SUTURE_FIELD(range(0.01, 0.9)) double dead_zone = 0.15;
  /// The hand is as fast as this while a stick is at its end.
  SUTURE_FIELD(unit("m/s"), range(0.001, 0.25)) double speed = 0.05;
  SUTURE_FIELD(unit("rad/s"), range(0.01, 2)) double turning_speed = 0.5;
  /// The gripper is open this far while the trigger is released.
  SUTURE_FIELD(unit("rad"), range(0, 1.047)) double opening = 0.5;
  /// A device that is not there is looked for once in this time.
  suture::Duration retry = std::chrono::seconds(1);
};

/// Moves the master as the sticks say (GamepadDecoder), as long as HeldMaster lets it. A device
/// that is gone ends the motion; its error is reported once, with the number of the system's error
/// as its code. The left shoulder is a pedal; while there is no device it is not fresh, so nobody
/// teleoperates. Nobody does so either until it has been pressed and released once, because a
/// device does not say how it is when it is opened.
class SUTURE_COMPONENT() Gamepad final : public suture::PeriodicTask, public FootPedals {
 public:
  /// Throws suture::SetupError for a range that is empty, or a `retry` that is not from 1 ms to a
  /// day.
  explicit Gamepad(const GamepadParameters& parameters);

  PedalState pedals() const override { return pedals_; }

  void run() override;
  void onStart() override;

 private:
  enum class Device : std::uint8_t { Unknown, There, Gone };

  void readEvents(suture::Time now);
  void find();
  void lose();
  void tellPedals(suture::Time now);
  HandInput input() const;

  const GamepadParameters parameters_;
  const std::string found_, gone_;  // texts
  suture::Required<Arm> master_{*this, "Master"};
  SUTURE_REQUIRED(optional())
  suture::Required<Teleoperation> teleoperation_{*this, "Teleoperation"};
  SUTURE_REQUIRED(optional()) suture::Required<GripperHand> hand_{*this, "Hand"};
  suture::Provided<FootPedals> pedalPort_{*this, "Pedals", *this};
  suture::MessagePort messages_{*this};
  HeldMaster held_{master_, teleoperation_, hand_, parameters_.opening};
  EventFile file_;
  GamepadDecoder decoder_;
  Device device_ = Device::Unknown;
  suture::Time lookedFor_;
  PedalState pedals_{.clutch = true, .camera = false, .coagulation = false, .stamp = {}};
};

}  // namespace robots
