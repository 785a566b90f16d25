// Written by suturec from reference/simulated_arm.h. Do not edit.
#include "reference/simulated_arm.suture.h"

#include <suture/component/json_reader.h>

#include <type_traits>

namespace reference {
namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SimulatedArmParameters::period), double>);
static_assert(std::is_same_v<decltype(SimulatedArmParameters::home), std::array<double, 3>>);
static_assert(std::is_same_v<decltype(SimulatedArmParameters::model), std::string>);

}  // namespace
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
