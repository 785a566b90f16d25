#include "person/gamepad_decoder.h"

#include <linux/input.h>
#include <suture/base/errors.h>

#include <algorithm>
#include <cmath>

namespace robots {
namespace {

bool isProper(const AxisRange& range) { return range.lowest < range.highest; }

/// Returns the share of the range, from 0 at the lowest to 1.
double share(const AxisRange& range, std::int32_t value) {
  const double lowest = range.lowest;
  return std::clamp((value - lowest) / (range.highest - lowest), 0.0, 1.0);
}

}  // namespace

GamepadDecoder::GamepadDecoder(const GamepadCalibration& calibration) : calibration_(calibration) {
  const bool possible = isProper(calibration.stick) && isProper(calibration.trigger) &&
                        calibration.dead_zone >= 0 && calibration.dead_zone < 1;
  if (possible) return;
  throw suture::SetupError("calibrating a gamepad", "a range or what its dead zone leaves is empty",
                           "State the ranges that evtest prints, and a dead zone below 1");
}

void GamepadDecoder::take(const input_event& event) {
  if (event.type == EV_SYN) return takeSynchronisation(event.code);
  if (dropping_) return;
  if (event.type == EV_ABS) takeAxis(event.code, event.value);
  if (event.type == EV_KEY && event.code == BTN_TL) next_.clutch = event.value != 0;
}

// If the kernel has dropped events, those that come up to the next report are of a state that is
// gone.
void GamepadDecoder::takeSynchronisation(std::uint16_t code) {
  if (code == SYN_DROPPED) {
    forget();
    dropping_ = true;
  } else if (code == SYN_REPORT) {
    dropping_ = false;
    state_ = next_;
  }
}

void GamepadDecoder::forget() {
  dropping_ = false;
  next_ = state_ = {};
}

// The y axes of the device point down, and so does that of its directional pad, which has the
// values -1, 0 and 1.
void GamepadDecoder::takeAxis(std::uint16_t code, std::int32_t value) {
  switch (code) {
    case ABS_X: next_.push.x() = deflection(value); break;
    case ABS_Y: next_.push.y() = -deflection(value); break;
    case ABS_RY: next_.push.z() = -deflection(value); break;
    case ABS_RX: next_.turn.z() = deflection(value); break;
    case ABS_HAT0X: next_.turn.y() = std::clamp(value, -1, 1); break;
    case ABS_HAT0Y: next_.turn.x() = -std::clamp(value, -1, 1); break;
    case ABS_RZ: next_.trigger = pressure(value); break;
    default: break;
  }
}

double GamepadDecoder::deflection(std::int32_t value) const {
  const double whole = 2 * share(calibration_.stick, value) - 1;
  const double beyond = std::abs(whole) - calibration_.dead_zone;
  return beyond <= 0 ? 0 : std::copysign(beyond / (1 - calibration_.dead_zone), whole);
}

double GamepadDecoder::pressure(std::int32_t value) const {
  return share(calibration_.trigger, value);
}

}  // namespace robots
