#pragma once
// This decodes the events of a gamepad.

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "person/axis_range.h"

struct input_event;  // linux/input.h

namespace robots {

struct GamepadCalibration {
  AxisRange stick{-32768, 32767};
  AxisRange trigger{0, 255};
  /// A stick is at rest within this share of the way from its middle to its end.
  double dead_zone = 0.15;
};

/// A GamepadState is the state of sticks and buttons. Axes go from -1 to 1; forward, right and up
/// are positive.
struct GamepadState {
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  /// Goes from 0, which is released, to 1; there is none until it has been touched.
  std::optional<double> trigger;
  /// Counts as pressed, because it might be, until somebody has pressed and released it.
  bool clutch = true;
};

/// One thread; only the constructor throws, nothing allocates.
///
/// Reads the events of Linux's gamepad protocol (Documentation/input/gamepad.rst of the kernel):
/// the left stick pushes along x and y, the right one along z and turns about z, the directional
/// pad turns about x and y, the right trigger is the gripper and the left shoulder the clutch.
/// Events count once their SYN_REPORT has come, all of them together.
class GamepadDecoder {
 public:
  /// Throws suture::SetupError unless both ranges, and the part of them that the dead zone leaves,
  /// are longer than 0.
  explicit GamepadDecoder(const GamepadCalibration& calibration);

  void take(const input_event& event);
  /// Says that the caller has missed events. Sticks are at rest until their next events, and the
  /// clutch counts as pressed, as in the beginning.
  void forget();

  const GamepadState& state() const { return state_; }

 private:
  void takeSynchronisation(std::uint16_t code);
  void takeAxis(std::uint16_t code, std::int32_t value);
  double deflection(std::int32_t value) const;
  double pressure(std::int32_t value) const;

  const GamepadCalibration calibration_;
  GamepadState next_, state_;
  bool dropping_ = false;  // events are ignored up to the next SYN_REPORT
};

}  // namespace robots
