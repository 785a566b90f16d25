// Written by suturec from robots/simulated_arm.h. Do not edit.
#include "robots/simulated_arm.suture.h"

#include <suture/component/json_reader.h>

#include <type_traits>

namespace robots {
namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(ArmParameters::rate), double>);
static_assert(std::is_same_v<decltype(ArmParameters::name), std::string>);
static_assert(std::is_same_v<decltype(ArmParameters::start), Mode>);

}  // namespace
}  // namespace robots

namespace robots {

inline void fromJson(const suture::JsonReader& in, Mode& value) {
  static constexpr Mode kValues[] = {Mode::Disabled, Mode::HoldStill, Mode::Servo};
  const int index = suture::enumeratorFromJson(in, {"Disabled", "HoldStill", "Servo"});
  if (index >= 0) value = kValues[index];
}

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
