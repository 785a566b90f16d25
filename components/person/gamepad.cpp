#include "person/gamepad.h"

#include "parameters/valid_time.h"

namespace robots {

Gamepad::Gamepad(const GamepadParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      parameters_(parameters),
      found_("the gamepad " + parameters.file +
             " is there; press and release its left shoulder before a slave shall follow"),
      gone_("there is no gamepad " + parameters.file + ": the hand rests until it is back"),
      file_(parameters.file),
      decoder_({parameters.stick, parameters.trigger, parameters.dead_zone}) {
  requireTime("retry", parameters.retry);
}

void Gamepad::onStart() {
  pedalPort_.emit().clutch(pedals_.clutch);
  pedalPort_.emit().camera(pedals_.camera);
  pedalPort_.emit().coagulation(pedals_.coagulation);
}

void Gamepad::run() {
  const suture::Time now = suture::now();
  readEvents(now);
  tellPedals(now);
  held_.move(input());
}

// The hand rests while the device is looked for, so it does no harm that the kernel may take its
// time.
void Gamepad::readEvents(suture::Time now) {
  if (!file_.isOpen()) {
    if (now - lookedFor_ < parameters_.retry) return;
    lookedFor_ = now;
    if (!file_.open()) return lose();
  }
  for (const input_event& event : file_.read()) decoder_.take(event);
  if (file_.isOpen()) return find();
  lose();
}

void Gamepad::find() {
  if (device_ != Device::There) messages_.status(found_);
  device_ = Device::There;
}

void Gamepad::lose() {
  if (device_ == Device::There) decoder_.forget();
  if (device_ != Device::Gone) messages_.error(gone_, static_cast<std::uint32_t>(file_.error()));
  device_ = Device::Gone;
}

void Gamepad::tellPedals(suture::Time now) {
  const bool pressed = decoder_.state().clutch;
  if (pressed != pedals_.clutch) pedalPort_.emit().clutch(pressed);
  pedals_.clutch = pressed;
  if (device_ == Device::There) pedals_.stamp = now;
}

HandInput Gamepad::input() const {
  const GamepadState& state = decoder_.state();
  HandInput input{.velocity = parameters_.speed * state.push,
                  .angular_velocity = parameters_.turning_speed * state.turn,
                  .opening = {}};
  if (state.trigger) input.opening = 1 - *state.trigger;
  return input;
}

}  // namespace robots
