// Written by suturec from surgeon/operator.h. Do not edit.
#include "surgeon/operator.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<ForceFeedback>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(ForceFeedback::None) == 0);
static_assert(static_cast<std::uint8_t>(ForceFeedback::PositionPosition) == 1);
static_assert(std::is_same_v<decltype(OperatorParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(OperatorParameters::target), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(OperatorParameters::scale), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::crossover_frequency), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::delay), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(OperatorParameters::remnant), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::seed), std::uint32_t>);
static_assert(std::is_same_v<decltype(OperatorParameters::tremor), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::speed), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::picture_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(OperatorParameters::force_feedback), ForceFeedback>);
static_assert(std::is_same_v<decltype(OperatorParameters::stiffness), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::damping), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::feel_fixtures), bool>);
static_assert(std::is_same_v<decltype(OperatorParameters::resistance), double>);
static_assert(std::is_same_v<decltype(OperatorParameters::passive), bool>);
static_assert(std::is_same_v<decltype(OperatorParameters::slave_age), std::chrono::nanoseconds>);

}  // namespace

bool store(const OperatorParameters& value, OperatorParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.target, slot.target);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.crossover_frequency, slot.crossover_frequency);
  fits &= store(value.delay, slot.delay);
  fits &= store(value.remnant, slot.remnant);
  fits &= store(value.seed, slot.seed);
  fits &= store(value.tremor, slot.tremor);
  fits &= store(value.speed, slot.speed);
  fits &= store(value.picture_age, slot.picture_age);
  fits &= store(value.force_feedback, slot.force_feedback);
  fits &= store(value.stiffness, slot.stiffness);
  fits &= store(value.damping, slot.damping);
  fits &= store(value.feel_fixtures, slot.feel_fixtures);
  fits &= store(value.resistance, slot.resistance);
  fits &= store(value.passive, slot.passive);
  fits &= store(value.slave_age, slot.slave_age);
  return fits;
}

void load(const OperatorParametersSlot& slot, OperatorParameters& value) {
  load(slot.period, value.period);
  load(slot.target, value.target);
  load(slot.scale, value.scale);
  load(slot.crossover_frequency, value.crossover_frequency);
  load(slot.delay, value.delay);
  load(slot.remnant, value.remnant);
  load(slot.seed, value.seed);
  load(slot.tremor, value.tremor);
  load(slot.speed, value.speed);
  load(slot.picture_age, value.picture_age);
  load(slot.force_feedback, value.force_feedback);
  load(slot.stiffness, value.stiffness);
  load(slot.damping, value.damping);
  load(slot.feel_fixtures, value.feel_fixtures);
  load(slot.resistance, value.resistance);
  load(slot.passive, value.passive);
  load(slot.slave_age, value.slave_age);
}

bool isKnownForceFeedback(std::uint8_t slot) {
  switch (static_cast<ForceFeedback>(slot)) {
    case ForceFeedback::None:
    case ForceFeedback::PositionPosition:
      return true;
  }
  return false;
}

bool isValid(const OperatorParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.target, path)) return suture::refusedAt(path, "target");
  if (!suture::inRange(slot.scale, 0.01, 10)) return suture::refusedAt(path, "scale");
  if (!suture::inRange(slot.crossover_frequency, 0.1, 20)) {
    return suture::refusedAt(path, "crossover_frequency");
  }
  if (!suture::inRange(slot.remnant, 0, 1)) return suture::refusedAt(path, "remnant");
  if (!suture::inRange(slot.tremor, 0, 0.002)) return suture::refusedAt(path, "tremor");
  if (!suture::inRange(slot.speed, 0.001, 1)) return suture::refusedAt(path, "speed");
  if (!isKnownForceFeedback(slot.force_feedback)) return suture::refusedAt(path, "force_feedback");
  if (!suture::inRange(slot.stiffness, 0, 5000)) return suture::refusedAt(path, "stiffness");
  if (!suture::inRange(slot.damping, 0, 100)) return suture::refusedAt(path, "damping");
  return suture::inRange(slot.resistance, 0, 1000) || suture::refusedAt(path, "resistance");
}

}  // namespace robots

namespace robots {

inline void fromJson(const suture::JsonReader& in, ForceFeedback& value) {
  static constexpr ForceFeedback kValues[] = {ForceFeedback::None, ForceFeedback::PositionPosition};
  const int index = suture::enumeratorFromJson(in, {"None", "PositionPosition"});
  if (index >= 0) value = kValues[index];
}

void fromJson(const suture::JsonReader& in, OperatorParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("target", value.target);
  reader.field("scale", value.scale, 0.01, 10);
  reader.field("crossover_frequency", value.crossover_frequency, 0.1, 20);
  reader.field("delay", value.delay);
  reader.field("remnant", value.remnant, 0, 1);
  reader.field("seed", value.seed);
  reader.field("tremor", value.tremor, 0, 0.002);
  reader.field("speed", value.speed, 0.001, 1);
  reader.field("picture_age", value.picture_age);
  reader.field("force_feedback", value.force_feedback);
  reader.field("stiffness", value.stiffness, 0, 5000);
  reader.field("damping", value.damping, 0, 100);
  reader.field("feel_fixtures", value.feel_fixtures);
  reader.field("resistance", value.resistance, 0, 1000);
  reader.field("passive", value.passive);
  reader.field("slave_age", value.slave_age);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Operator>() {
  return {"Operator", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::OperatorParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Operator(values));
          }};
}

}  // namespace suture
