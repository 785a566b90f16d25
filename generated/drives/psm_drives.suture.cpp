// Written by suturec from drives/psm_drives.h. Do not edit.
#include "drives/psm_drives.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "drives/psm_drives.capnp.h"

// Defined in drives/drive_dynamics.suture.cpp.
namespace robots {
wire::DriveDynamics wireDriveDynamics(std::uint8_t slot);
bool isKnownDriveDynamics(std::uint8_t slot);
suture::Errc fromWire(wire::DriveDynamics in, std::uint8_t& slot);
void toWire(const RigidBodyOptionsSlot& slot, wire::RigidBodyOptions::Builder out);
suture::Errc fromWire(wire::RigidBodyOptions::Reader in, RigidBodyOptionsSlot& slot,
                      suture::Duration shift);
bool isValid(const RigidBodyOptionsSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const PsmDrivesParametersSlot& slot, wire::PsmDrivesParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setTimeConstant(slot.time_constant);
  out.setAngularRate(slot.angular_rate);
  out.setInsertionRate(slot.insertion_rate);
  out.setJawRate(slot.jaw_rate);
  out.setPermit(slot.permit);
  out.setDynamics(wireDriveDynamics(slot.dynamics));
  toWire(slot.rigid_body, out.initRigidBody());
}

suture::Errc fromWire(wire::PsmDrivesParameters::Reader in, PsmDrivesParametersSlot& slot,
                      suture::Duration shift) {
  slot.period = in.getPeriod();
  slot.time_constant = in.getTimeConstant();
  slot.angular_rate = in.getAngularRate();
  slot.insertion_rate = in.getInsertionRate();
  slot.jaw_rate = in.getJawRate();
  slot.permit = in.getPermit();
  return suture::rpc::firstError({
      fromWire(in.getDynamics(), slot.dynamics),
      fromWire(in.getRigidBody(), slot.rigid_body, shift),
  });
}

bool isValid(const PsmDrivesParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.time_constant, 0.0001, 10)) {
    return suture::refusedAt(path, "time_constant");
  }
  if (!suture::rpc::inRange(slot.angular_rate, 0.01, 20)) {
    return suture::refusedAt(path, "angular_rate");
  }
  if (!suture::rpc::inRange(slot.insertion_rate, 0.001, 2)) {
    return suture::refusedAt(path, "insertion_rate");
  }
  if (!suture::rpc::inRange(slot.jaw_rate, 0.01, 50)) return suture::refusedAt(path, "jaw_rate");
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
Result<std::vector<std::byte>> encode(const robots::PsmDrivesParameters& value) {
  return rpc::encodeAs<robots::wire::PsmDrivesParameters, robots::PsmDrivesParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PsmDrivesParameters& value) {
  return rpc::decodeAs<robots::wire::PsmDrivesParameters,
                       robots::PsmDrivesParametersSlot>(bytes, value);
}

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
