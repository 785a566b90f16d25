// Written by suturec from drives/psm_drives.h. Do not edit.
#include "drives/psm_drives.suture.h"

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
static_assert(std::is_same_v<decltype(PsmDrivesParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::time_constant), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::angular_rate), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::insertion_rate), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::jaw_rate), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::permit), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::dynamics), DriveDynamics>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::rigid_body), RigidBodyOptions>);

}  // namespace

bool store(const PsmDrivesParameters& value, PsmDrivesParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.time_constant, slot.time_constant);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.insertion_rate, slot.insertion_rate);
  fits &= store(value.jaw_rate, slot.jaw_rate);
  fits &= store(value.permit, slot.permit);
  fits &= store(value.dynamics, slot.dynamics);
  fits &= store(value.rigid_body, slot.rigid_body);
  return fits;
}

void load(const PsmDrivesParametersSlot& slot, PsmDrivesParameters& value) {
  load(slot.period, value.period);
  load(slot.time_constant, value.time_constant);
  load(slot.angular_rate, value.angular_rate);
  load(slot.insertion_rate, value.insertion_rate);
  load(slot.jaw_rate, value.jaw_rate);
  load(slot.permit, value.permit);
  load(slot.dynamics, value.dynamics);
  load(slot.rigid_body, value.rigid_body);
}

bool isValid(const PsmDrivesParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.time_constant, 0.0001, 10)) {
    return suture::refusedAt(path, "time_constant");
  }
  if (!suture::inRange(slot.angular_rate, 0.01, 20)) return suture::refusedAt(path, "angular_rate");
  if (!suture::inRange(slot.insertion_rate, 0.001, 2)) {
    return suture::refusedAt(path, "insertion_rate");
  }
  if (!suture::inRange(slot.jaw_rate, 0.01, 50)) return suture::refusedAt(path, "jaw_rate");
  if (!isKnownDriveDynamics(slot.dynamics)) return suture::refusedAt(path, "dynamics");
  return isValid(slot.rigid_body, path) || suture::refusedAt(path, "rigid_body");
}

}  // namespace robots

// Defined in drives/drive_dynamics.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, DriveDynamics& value);
void fromJson(const suture::JsonReader& in, RigidBodyOptions& value);
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, PsmDrivesParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("time_constant", value.time_constant, 0.0001, 10);
  reader.field("angular_rate", value.angular_rate, 0.01, 20);
  reader.field("insertion_rate", value.insertion_rate, 0.001, 2);
  reader.field("jaw_rate", value.jaw_rate, 0.01, 50);
  reader.field("permit", value.permit);
  reader.field("dynamics", value.dynamics);
  reader.field("rigid_body", value.rigid_body);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::PsmDrives>() {
  return {"PsmDrives", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::PsmDrivesParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::PsmDrives(values));
            makeOptional(*component, {"Stop"});
            return component;
          }};
}

}  // namespace suture
