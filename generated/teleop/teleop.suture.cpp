// Written by suturec from teleop/teleop.h. Do not edit.
#include "teleop/teleop.suture.h"

#include <suture/component/json_reader.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "teleop/teleop.capnp.h"

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
static_assert(std::is_same_v<decltype(TeleopParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::scale), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::max_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::enable_at_start), bool>);

}  // namespace

bool store(const TeleopParameters& value, TeleopParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.max_age, slot.max_age);
  fits &= store(value.enable_at_start, slot.enable_at_start);
  return fits;
}

void load(const TeleopParametersSlot& slot, TeleopParameters& value) {
  load(slot.period, value.period);
  load(slot.scale, value.scale);
  load(slot.max_age, value.max_age);
  load(slot.enable_at_start, value.enable_at_start);
}

// --- between slots and Cap'n Proto

void toWire(const TeleopParametersSlot& slot, wire::TeleopParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setScale(slot.scale);
  out.setMaxAge(slot.max_age);
  out.setEnableAtStart(slot.enable_at_start != 0);
}

Errc fromWire(wire::TeleopParameters::Reader in, TeleopParametersSlot& slot, Duration) {
  slot.period = in.getPeriod();
  slot.scale = in.getScale();
  slot.max_age = in.getMaxAge();
  slot.enable_at_start = in.getEnableAtStart();
  return Errc{};
}

bool isValid(const TeleopParametersSlot& slot, FieldPath* path) {
  return inRange(slot.scale, 0.01, 10) || refusedAt(path, "scale");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, TeleopParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("scale", value.scale, 0.01, 10);
  reader.field("max_age", value.max_age);
  reader.field("enable_at_start", value.enable_at_start);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Teleop>() {
  return {"Teleop", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::TeleopParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Teleop(values));
          }};
}

}  // namespace suture
