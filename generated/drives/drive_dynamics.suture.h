// Written by suturec from drives/drive_dynamics.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "drives/drive_dynamics.h"

namespace robots {

/// Chooses the properties of joints with mass.
struct RigidBodyOptionsSlot {
  std::uint8_t gravity_compensation;  // bool
  std::uint8_t quantisation;          // bool
  double noise;
  std::uint32_t seed;
  std::uint8_t brakes;  // bool
  double current_gain;
};

bool store(const RigidBodyOptions& value, RigidBodyOptionsSlot& slot);
void load(const RigidBodyOptionsSlot& slot, RigidBodyOptions& value);

bool isKnownDriveDynamics(std::uint8_t slot);
bool isValid(const RigidBodyOptionsSlot& slot, suture::FieldPath* path);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::RigidBodyOptions& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::RigidBodyOptions& value);

}  // namespace suture
