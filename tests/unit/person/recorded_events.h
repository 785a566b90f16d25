#pragma once
// These are events of a gamepad, as the kernel's evdev writes them.

#include <linux/input.h>

#include <cstdint>
#include <vector>

namespace robots::test {

inline input_event event(std::uint16_t type, std::uint16_t code, std::int32_t value) {
  return {.time = {}, .type = type, .code = code, .value = value};
}
inline input_event axis(std::uint16_t code, std::int32_t value) {
  return event(EV_ABS, code, value);
}
inline input_event button(std::uint16_t code, bool pressed) {
  return event(EV_KEY, code, pressed ? 1 : 0);
}
inline input_event report() { return event(EV_SYN, SYN_REPORT, 0); }
inline input_event dropped() { return event(EV_SYN, SYN_DROPPED, 0); }

/// Returns what a pad with sticks of 16 bits says when the left one is pushed all the way to the
/// right.
inline std::vector<input_event> stickToTheRight() { return {axis(ABS_X, 32767), report()}; }
/// Returns what it says when it is let go: such sticks come back near to their middle.
inline std::vector<input_event> stickReleased() { return {axis(ABS_X, 391), report()}; }

}  // namespace robots::test
