// Written by suturec from vision/synthetic_endoscope.h. Do not edit.
#include "vision/synthetic_endoscope.suture.h"

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
static_assert(std::is_same_v<decltype(EndoscopeParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::noise), double>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::blur), double>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::dropout), double>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::latency), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(EndoscopeParameters::vergence), double>);

}  // namespace

bool store(const EndoscopeParameters& value, EndoscopeParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.noise, slot.noise);
  fits &= store(value.blur, slot.blur);
  fits &= store(value.dropout, slot.dropout);
  fits &= store(value.latency, slot.latency);
  fits &= store(value.vergence, slot.vergence);
  return fits;
}

void load(const EndoscopeParametersSlot& slot, EndoscopeParameters& value) {
  load(slot.period, value.period);
  load(slot.noise, value.noise);
  load(slot.blur, value.blur);
  load(slot.dropout, value.dropout);
  load(slot.latency, value.latency);
  load(slot.vergence, value.vergence);
}

bool isValid(const EndoscopeParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.noise, 0, 5)) return suture::refusedAt(path, "noise");
  if (!suture::inRange(slot.blur, 0, 3)) return suture::refusedAt(path, "blur");
  if (!suture::inRange(slot.dropout, 0, 1)) return suture::refusedAt(path, "dropout");
  return suture::inRange(slot.vergence, -0.1, 0.1) || suture::refusedAt(path, "vergence");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, EndoscopeParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("noise", value.noise, 0, 5);
  reader.field("blur", value.blur, 0, 3);
  reader.field("dropout", value.dropout, 0, 1);
  reader.field("latency", value.latency);
  reader.field("vergence", value.vergence, -0.1, 0.1);
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
