// Written by suturec from robots/simulated_arm.h. Do not edit.
#include "robots/simulated_arm.suture.h"

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
static_assert(std::is_same_v<decltype(ArmParameters::rate), double>);
static_assert(std::is_same_v<decltype(ArmParameters::name), std::string>);
static_assert(std::is_same_v<decltype(ArmParameters::start), Mode>);

}  // namespace

bool store(const ArmParameters& value, ArmParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.rate, slot.rate);
  fits &= store(value.name, slot.name);
  fits &= store(value.start, slot.start);
  return fits;
}

void load(const ArmParametersSlot& slot, ArmParameters& value) {
  load(slot.rate, value.rate);
  load(slot.name, value.name);
  load(slot.start, value.start);
}

bool isValid(const ArmParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.rate, 1, 4000)) return suture::refusedAt(path, "rate");
  return isKnownMode(slot.start) || suture::refusedAt(path, "start");
}

}  // namespace robots

// Defined in robots/arm.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, Mode& value);
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, ArmParameters& value) {
  suture::JsonReader reader = in;
  reader.field("rate", value.rate, 1, 4000);
  reader.field("name", value.name);
  reader.field("start", value.start);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::SimulatedArm>() {
  return {"SimulatedArm", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::ArmParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::SimulatedArm(values));
          }};
}

}  // namespace suture
