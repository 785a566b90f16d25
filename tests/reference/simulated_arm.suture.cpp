// Written by suturec from reference/simulated_arm.h. Do not edit.
#include "reference/simulated_arm.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace reference {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SimulatedArmParameters::period), double>);
static_assert(std::is_same_v<decltype(SimulatedArmParameters::home), std::array<double, 3>>);
static_assert(std::is_same_v<decltype(SimulatedArmParameters::model), std::string>);

}  // namespace

bool store(const SimulatedArmParameters& value, SimulatedArmParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.home, slot.home);
  fits &= store(value.model, slot.model);
  return fits;
}

void load(const SimulatedArmParametersSlot& slot, SimulatedArmParameters& value) {
  load(slot.period, value.period);
  load(slot.home, value.home);
  load(slot.model, value.model);
}

bool isValid(const SimulatedArmParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.period, 0.0001, 1)) return suture::refusedAt(path, "period");
  return isValid(slot.home, path) || suture::refusedAt(path, "home");
}

}  // namespace reference

namespace reference {

void fromJson(const suture::JsonReader& in, SimulatedArmParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period, 0.0001, 1);
  reader.field("home", value.home);
  reader.field("model", value.model);
  reader.finish();
}

}  // namespace reference

namespace suture {

template <>
ComponentClass componentClass<reference::SimulatedArm>() {
  return {"SimulatedArm", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            reference::SimulatedArmParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new reference::SimulatedArm(values));
          }};
}

}  // namespace suture
