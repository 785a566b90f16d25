// Written by suturec from surgeon/surgeon.h. Do not edit.
#include "surgeon/surgeon.suture.h"

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
static_assert(std::is_same_v<decltype(SurgeonParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(SurgeonParameters::amplitude), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::turn), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::frequency), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::opening), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::ramp), double>);

}  // namespace

bool store(const SurgeonParameters& value, SurgeonParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.amplitude, slot.amplitude);
  fits &= store(value.turn, slot.turn);
  fits &= store(value.frequency, slot.frequency);
  fits &= store(value.opening, slot.opening);
  fits &= store(value.ramp, slot.ramp);
  return fits;
}

void load(const SurgeonParametersSlot& slot, SurgeonParameters& value) {
  load(slot.period, value.period);
  load(slot.amplitude, value.amplitude);
  load(slot.turn, value.turn);
  load(slot.frequency, value.frequency);
  load(slot.opening, value.opening);
  load(slot.ramp, value.ramp);
}

bool isValid(const SurgeonParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.amplitude, 0, 0.2)) return suture::refusedAt(path, "amplitude");
  if (!suture::inRange(slot.turn, 0, 1)) return suture::refusedAt(path, "turn");
  if (!suture::inRange(slot.frequency, 0.001, 10)) return suture::refusedAt(path, "frequency");
  if (!suture::inRange(slot.opening, 0, 1.047)) return suture::refusedAt(path, "opening");
  return suture::inRange(slot.ramp, 0.1, 100) || suture::refusedAt(path, "ramp");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, SurgeonParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("amplitude", value.amplitude, 0, 0.2);
  reader.field("turn", value.turn, 0, 1);
  reader.field("frequency", value.frequency, 0.001, 10);
  reader.field("opening", value.opening, 0, 1.047);
  reader.field("ramp", value.ramp, 0.1, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Surgeon>() {
  return {"Surgeon", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::SurgeonParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Surgeon(values));
            makeOptional(*component, {"Teleoperation", "Hand"});
            return component;
          }};
}

}  // namespace suture
