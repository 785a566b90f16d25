// Written by suturec from drives/drive_dynamics.h. Do not edit.
#include "drives/drive_dynamics.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<DriveDynamics>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(DriveDynamics::Lag) == 0);
static_assert(static_cast<std::uint8_t>(DriveDynamics::RigidBody) == 1);
static_assert(std::is_same_v<decltype(RigidBodyOptions::gravity_compensation), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::quantisation), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::noise), double>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::seed), std::uint32_t>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::brakes), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::current_gain), double>);

}  // namespace

bool store(const RigidBodyOptions& value, RigidBodyOptionsSlot& slot) {
  bool fits = true;
  fits &= store(value.gravity_compensation, slot.gravity_compensation);
  fits &= store(value.quantisation, slot.quantisation);
  fits &= store(value.noise, slot.noise);
  fits &= store(value.seed, slot.seed);
  fits &= store(value.brakes, slot.brakes);
  fits &= store(value.current_gain, slot.current_gain);
  return fits;
}

void load(const RigidBodyOptionsSlot& slot, RigidBodyOptions& value) {
  load(slot.gravity_compensation, value.gravity_compensation);
  load(slot.quantisation, value.quantisation);
  load(slot.noise, value.noise);
  load(slot.seed, value.seed);
  load(slot.brakes, value.brakes);
  load(slot.current_gain, value.current_gain);
}

bool isKnownDriveDynamics(std::uint8_t slot) {
  switch (static_cast<DriveDynamics>(slot)) {
    case DriveDynamics::Lag:
    case DriveDynamics::RigidBody:
      return true;
  }
  return false;
}

bool isValid(const RigidBodyOptionsSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.noise, 0, 1000)) return suture::refusedAt(path, "noise");
  return suture::inRange(slot.current_gain, 0.1, 100) || suture::refusedAt(path, "current_gain");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, DriveDynamics& value) {
  static constexpr DriveDynamics kValues[] = {DriveDynamics::Lag, DriveDynamics::RigidBody};
  const int index = suture::enumeratorFromJson(in, {"Lag", "RigidBody"});
  if (index >= 0) value = kValues[index];
}

void fromJson(const suture::JsonReader& in, RigidBodyOptions& value) {
  suture::JsonReader reader = in;
  reader.field("gravity_compensation", value.gravity_compensation);
  reader.field("quantisation", value.quantisation);
  reader.field("noise", value.noise, 0, 1000);
  reader.field("seed", value.seed);
  reader.field("brakes", value.brakes);
  reader.field("current_gain", value.current_gain, 0.1, 100);
  reader.finish();
}

}  // namespace robots
