// Written by suturec from robot_types/inputs.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

#include "robot_types/inputs.h"

namespace robots {

/// prmEventButton.
struct ButtonEventSlot {
  std::uint8_t type;   // ButtonAction
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const ButtonEvent& value, ButtonEventSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.type, slot.type);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const ButtonEventSlot& slot, ButtonEvent& value) {
  using suture::load;
  load(slot.type, value.type);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmInputData.
struct InputDataSlot {
  suture::BoundedList<double, 32> analog_inputs;
  suture::BoundedList<std::uint8_t, 64> digital_inputs;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

inline bool store(const InputData& value, InputDataSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.analog_inputs, slot.analog_inputs);
  fits &= store(value.digital_inputs, slot.digital_inputs);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const InputDataSlot& slot, InputData& value) {
  using suture::load;
  load(slot.analog_inputs, value.analog_inputs);
  load(slot.digital_inputs, value.digital_inputs);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

/// prmIMUSensors.
struct ImuSampleSlot {
  std::array<double, 4> orientation;          // Eigen::Quaterniond
  std::array<double, 3> angular_velocity;     // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;  // Eigen::Vector3d, m/s2
  std::int64_t stamp;                         // suture::Time, ns
  std::uint8_t valid;                         // bool
};

inline bool store(const ImuSample& value, ImuSampleSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.orientation, slot.orientation);
  fits &= store(value.angular_velocity, slot.angular_velocity);
  fits &= store(value.linear_acceleration, slot.linear_acceleration);
  fits &= store(value.stamp, slot.stamp);
  fits &= store(value.valid, slot.valid);
  return fits;
}

inline void load(const ImuSampleSlot& slot, ImuSample& value) {
  using suture::load;
  load(slot.orientation, value.orientation);
  load(slot.angular_velocity, value.angular_velocity);
  load(slot.linear_acceleration, value.linear_acceleration);
  load(slot.stamp, value.stamp);
  load(slot.valid, value.valid);
}

}  // namespace robots
