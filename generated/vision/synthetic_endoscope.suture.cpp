// Written by suturec from vision/synthetic_endoscope.h. Do not edit.
#include "vision/synthetic_endoscope.suture.h"

#include <suture/component/json_reader.h>
#include <suture/transport/rpc/wire.h>

#include <type_traits>

#include "vision/synthetic_endoscope.capnp.h"

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
static_assert(std::is_same_v<decltype(EndoscopeParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::noise), double>);

}  // namespace

bool store(const EndoscopeParameters& value, EndoscopeParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.noise, slot.noise);
  return fits;
}

void load(const EndoscopeParametersSlot& slot, EndoscopeParameters& value) {
  load(slot.period, value.period);
  load(slot.noise, value.noise);
}

// --- between slots and Cap'n Proto

void toWire(const EndoscopeParametersSlot& slot, wire::EndoscopeParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setNoise(slot.noise);
}

Errc fromWire(wire::EndoscopeParameters::Reader in, EndoscopeParametersSlot& slot, Duration) {
  slot.period = in.getPeriod();
  slot.noise = in.getNoise();
  return Errc{};
}

bool isValid(const EndoscopeParametersSlot& slot, FieldPath* path) {
  return inRange(slot.noise, 0, 5) || refusedAt(path, "noise");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, EndoscopeParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("noise", value.noise, 0, 5);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::SyntheticEndoscope>() {
  return {"SyntheticEndoscope", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::EndoscopeParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::SyntheticEndoscope(values));
          }};
}

}  // namespace suture
