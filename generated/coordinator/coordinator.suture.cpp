// Written by suturec from coordinator/coordinator.h. Do not edit.
#include "coordinator/coordinator.suture.h"

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
static_assert(std::is_same_v<decltype(CoordinatorParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(CoordinatorParameters::buttons), std::vector<std::string>>);

}  // namespace

bool store(const CoordinatorParameters& value, CoordinatorParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.buttons, slot.buttons);
  return fits;
}

void load(const CoordinatorParametersSlot& slot, CoordinatorParameters& value) {
  load(slot.period, value.period);
  load(slot.buttons, value.buttons);
}

void reserve(const CoordinatorParametersSlot*, CoordinatorParameters& value) {
  suture::reserveFor<decltype(CoordinatorParametersSlot::buttons)>(value.buttons);
}

bool isValid(const CoordinatorParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, CoordinatorParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("buttons", value.buttons);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Coordinator>() {
  return {"Coordinator", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::CoordinatorParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Coordinator(values));
          }};
}

}  // namespace suture
