// Written by suturec from drives/mtm_drives.h. Do not edit.
#include "drives/mtm_drives.suture.h"

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
static_assert(std::is_same_v<decltype(MtmDrivesParameters::side), Side>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::time_constant), double>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::angular_rate), double>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::permit), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::dynamics), DriveDynamics>);
static_assert(std::is_same_v<decltype(MtmDrivesParameters::rigid_body), RigidBodyOptions>);

}  // namespace

bool store(const MtmDrivesParameters& value, MtmDrivesParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.side, slot.side);
  fits &= store(value.period, slot.period);
  fits &= store(value.time_constant, slot.time_constant);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.permit, slot.permit);
  fits &= store(value.dynamics, slot.dynamics);
  fits &= store(value.rigid_body, slot.rigid_body);
  return fits;
}

void load(const MtmDrivesParametersSlot& slot, MtmDrivesParameters& value) {
  load(slot.side, value.side);
  load(slot.period, value.period);
  load(slot.time_constant, value.time_constant);
  load(slot.angular_rate, value.angular_rate);
  load(slot.permit, value.permit);
  load(slot.dynamics, value.dynamics);
  load(slot.rigid_body, value.rigid_body);
}

bool isValid(const MtmDrivesParametersSlot& slot, suture::FieldPath* path) {
  if (!isKnownSide(slot.side)) return suture::refusedAt(path, "side");
  if (!suture::inRange(slot.time_constant, 0.0001, 10)) {
    return suture::refusedAt(path, "time_constant");
  }
  if (!suture::inRange(slot.angular_rate, 0.01, 20)) return suture::refusedAt(path, "angular_rate");
  if (!isKnownDriveDynamics(slot.dynamics)) return suture::refusedAt(path, "dynamics");
  return isValid(slot.rigid_body, path) || suture::refusedAt(path, "rigid_body");
}

}  // namespace robots

// Defined in arm_control/mtm.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, Side& value);
}  // namespace robots

// Defined in drives/drive_dynamics.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, DriveDynamics& value);
void fromJson(const suture::JsonReader& in, RigidBodyOptions& value);
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, MtmDrivesParameters& value) {
  suture::JsonReader reader = in;
  reader.field("side", value.side);
  reader.field("period", value.period);
  reader.field("time_constant", value.time_constant, 0.0001, 10);
  reader.field("angular_rate", value.angular_rate, 0.01, 20);
  reader.field("permit", value.permit);
  reader.field("dynamics", value.dynamics);
  reader.field("rigid_body", value.rigid_body);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::MtmDrives>() {
  return {"MtmDrives", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::MtmDrivesParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::MtmDrives(values));
            makeOptional(*component, {"Stop"});
            return component;
          }};
}

}  // namespace suture
