// Written by suturec from strand/strand_simulation.h. Do not edit.
#include "strand/strand_simulation.suture.h"

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
static_assert(std::is_same_v<decltype(StrandParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(StrandParameters::length), double>);
static_assert(std::is_same_v<decltype(StrandParameters::friction), double>);
static_assert(std::is_same_v<decltype(StrandParameters::wrap), double>);

}  // namespace

bool store(const StrandParameters& value, StrandParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.length, slot.length);
  fits &= store(value.friction, slot.friction);
  fits &= store(value.wrap, slot.wrap);
  return fits;
}

void load(const StrandParametersSlot& slot, StrandParameters& value) {
  load(slot.period, value.period);
  load(slot.length, value.length);
  load(slot.friction, value.friction);
  load(slot.wrap, value.wrap);
}

bool isValid(const StrandParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.length, 0.02, 1)) return suture::refusedAt(path, "length");
  if (!suture::inRange(slot.friction, 0, 1)) return suture::refusedAt(path, "friction");
  return suture::inRange(slot.wrap, 0, 100) || suture::refusedAt(path, "wrap");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, StrandParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("length", value.length, 0.02, 1);
  reader.field("friction", value.friction, 0, 1);
  reader.field("wrap", value.wrap, 0, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::StrandSimulation>() {
  return {"StrandSimulation", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::StrandParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::StrandSimulation(values));
          }};
}

}  // namespace suture
