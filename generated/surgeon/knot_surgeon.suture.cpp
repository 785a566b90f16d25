// Written by suturec from surgeon/knot_surgeon.h. Do not edit.
#include "surgeon/knot_surgeon.suture.h"

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
static_assert(std::is_same_v<decltype(KnotSurgeonParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(KnotSurgeonParameters::carry), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(KnotSurgeonParameters::duration), double>);
static_assert(std::is_same_v<decltype(KnotSurgeonParameters::sway), double>);
static_assert(std::is_same_v<decltype(KnotSurgeonParameters::sway_frequency), double>);

}  // namespace

bool store(const KnotSurgeonParameters& value, KnotSurgeonParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.carry, slot.carry);
  fits &= store(value.duration, slot.duration);
  fits &= store(value.sway, slot.sway);
  fits &= store(value.sway_frequency, slot.sway_frequency);
  return fits;
}

void load(const KnotSurgeonParametersSlot& slot, KnotSurgeonParameters& value) {
  load(slot.period, value.period);
  load(slot.carry, value.carry);
  load(slot.duration, value.duration);
  load(slot.sway, value.sway);
  load(slot.sway_frequency, value.sway_frequency);
}

bool isValid(const KnotSurgeonParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.carry, path)) return suture::refusedAt(path, "carry");
  if (!suture::inRange(slot.duration, 0.1, 100)) return suture::refusedAt(path, "duration");
  if (!suture::inRange(slot.sway, 0, 0.05)) return suture::refusedAt(path, "sway");
  return suture::inRange(slot.sway_frequency, 0, 10) || suture::refusedAt(path, "sway_frequency");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, KnotSurgeonParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("carry", value.carry);
  reader.field("duration", value.duration, 0.1, 100);
  reader.field("sway", value.sway, 0, 0.05);
  reader.field("sway_frequency", value.sway_frequency, 0, 10);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::KnotSurgeon>() {
  return {"KnotSurgeon", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::KnotSurgeonParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::KnotSurgeon(values));
          }};
}

}  // namespace suture
