#pragma once
// These are buttons, analogue and digital inputs, and inertial sensors.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace robots {

enum class SUTURE_TYPE() ButtonAction : std::uint8_t {
  Undefined,
  Pressed,
  Released,
  Clicked,
  DoubleClicked,
};

/// Corresponds to cisst's prmEventButton.
struct SUTURE_TYPE() ButtonEvent {
  ButtonAction type = ButtonAction::Undefined;
  suture::Time stamp;
  bool valid = false;
};

/// Corresponds to cisst's prmInputData.
struct SUTURE_TYPE() InputData {
  SUTURE_FIELD(capacity(32)) std::vector<double> analog_inputs;
  SUTURE_FIELD(capacity(64)) std::vector<bool> digital_inputs;
  suture::Time stamp;
  bool valid = false;
};

/// Corresponds to cisst's prmIMUSensors.
struct SUTURE_TYPE() ImuSample {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  SUTURE_FIELD(unit("rad/s")) Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  SUTURE_FIELD(unit("m/s2")) Eigen::Vector3d linear_acceleration = Eigen::Vector3d::Zero();
  suture::Time stamp;
  bool valid = false;
};

}  // namespace robots
