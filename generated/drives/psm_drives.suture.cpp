// Written by suturec from drives/psm_drives.h. Do not edit.
#include "drives/psm_drives.suture.h"

#include <suture/component/json_reader.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "drives/psm_drives.capnp.h"

namespace robots {

using suture::Duration;
using suture::Errc;
using suture::FieldPath;
using suture::load;
using suture::refusedAt;
using suture::rpc::fromWire;
using suture::rpc::inRange;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(PsmDrivesParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::time_constant), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::angular_rate), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::insertion_rate), double>);
static_assert(std::is_same_v<decltype(PsmDrivesParameters::permit), std::chrono::nanoseconds>);

}  // namespace

bool store(const PsmDrivesParameters& value, PsmDrivesParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.time_constant, slot.time_constant);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.insertion_rate, slot.insertion_rate);
  fits &= store(value.permit, slot.permit);
  return fits;
}

void load(const PsmDrivesParametersSlot& slot, PsmDrivesParameters& value) {
  load(slot.period, value.period);
  load(slot.time_constant, value.time_constant);
  load(slot.angular_rate, value.angular_rate);
  load(slot.insertion_rate, value.insertion_rate);
  load(slot.permit, value.permit);
}

// --- between slots and Cap'n Proto

void toWire(const PsmDrivesParametersSlot& slot, wire::PsmDrivesParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setTimeConstant(slot.time_constant);
  out.setAngularRate(slot.angular_rate);
  out.setInsertionRate(slot.insertion_rate);
  out.setPermit(slot.permit);
}

Errc fromWire(wire::PsmDrivesParameters::Reader in, PsmDrivesParametersSlot& slot, Duration) {
  slot.period = in.getPeriod();
  slot.time_constant = in.getTimeConstant();
  slot.angular_rate = in.getAngularRate();
  slot.insertion_rate = in.getInsertionRate();
  slot.permit = in.getPermit();
  return Errc{};
}

bool isValid(const PsmDrivesParametersSlot& slot, FieldPath* path) {
  if (!inRange(slot.time_constant, 0.0001, 10)) return refusedAt(path, "time_constant");
  if (!inRange(slot.angular_rate, 0.01, 20)) return refusedAt(path, "angular_rate");
  return inRange(slot.insertion_rate, 0.001, 2) || refusedAt(path, "insertion_rate");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, PsmDrivesParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("time_constant", value.time_constant, 0.0001, 10);
  reader.field("angular_rate", value.angular_rate, 0.01, 20);
  reader.field("insertion_rate", value.insertion_rate, 0.001, 2);
  reader.field("permit", value.permit);
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
