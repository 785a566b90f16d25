// Written by suturec from robot_types/inputs.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "robot_types/inputs.h"

namespace robots {

/// Corresponds to cisst's prmEventButton.
struct ButtonEventSlot {
  std::uint8_t type;   // ButtonAction
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const ButtonEvent& value, ButtonEventSlot& slot);
void load(const ButtonEventSlot& slot, ButtonEvent& value);
void shiftStamps(ButtonEventSlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmInputData.
struct InputDataSlot {
  suture::BoundedList<double, 32> analog_inputs;
  suture::BoundedList<std::uint8_t, 64> digital_inputs;
  std::int64_t stamp;  // suture::Time, ns
  std::uint8_t valid;  // bool
};

bool store(const InputData& value, InputDataSlot& slot);
void load(const InputDataSlot& slot, InputData& value);
void reserve(const InputDataSlot*, InputData& value);
void shiftStamps(InputDataSlot& slot, suture::Duration shift);

/// Corresponds to cisst's prmIMUSensors.
struct ImuSampleSlot {
  std::array<double, 4> orientation;          // Eigen::Quaterniond
  std::array<double, 3> angular_velocity;     // Eigen::Vector3d, rad/s
  std::array<double, 3> linear_acceleration;  // Eigen::Vector3d, m/s2
  std::int64_t stamp;                         // suture::Time, ns
  std::uint8_t valid;                         // bool
};

bool store(const ImuSample& value, ImuSampleSlot& slot);
void load(const ImuSampleSlot& slot, ImuSample& value);
void shiftStamps(ImuSampleSlot& slot, suture::Duration shift);

bool isKnownButtonAction(std::uint8_t slot);
bool isValid(const ButtonEventSlot& slot, suture::FieldPath* path);
bool isValid(const InputDataSlot& slot, suture::FieldPath* path);
bool isValid(const ImuSampleSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ButtonEvent& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ButtonEvent& value);

template <>
Result<std::vector<std::byte>> encode(const robots::InputData& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::InputData& value);

template <>
Result<std::vector<std::byte>> encode(const robots::ImuSample& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ImuSample& value);

}  // namespace suture
