// Written by suturec from guidance/knot_guide.h. Do not edit.
#include "guidance/knot_guide.suture.h"

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
static_assert(std::is_same_v<decltype(GuideParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::scale), double>);
static_assert(std::is_same_v<decltype(GuideParameters::max_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::sighting_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::registration_age),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::operator_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::enable_at_start), bool>);
static_assert(std::is_same_v<decltype(GuideParameters::preparation_limit),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GuideParameters::fixtures), bool>);
static_assert(std::is_same_v<decltype(GuideParameters::target), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(GuideParameters::approach), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(GuideParameters::radius), double>);
static_assert(std::is_same_v<decltype(GuideParameters::slope), double>);
static_assert(std::is_same_v<decltype(GuideParameters::speed), double>);
static_assert(std::is_same_v<decltype(GuideParameters::separation), double>);
static_assert(std::is_same_v<decltype(GuideParameters::friction), double>);
static_assert(std::is_same_v<decltype(GuideParameters::wrap), double>);
static_assert(std::is_same_v<decltype(GuideParameters::master_damping), double>);

}  // namespace

bool store(const GuideParameters& value, GuideParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.max_age, slot.max_age);
  fits &= store(value.sighting_age, slot.sighting_age);
  fits &= store(value.registration_age, slot.registration_age);
  fits &= store(value.operator_age, slot.operator_age);
  fits &= store(value.enable_at_start, slot.enable_at_start);
  fits &= store(value.preparation_limit, slot.preparation_limit);
  fits &= store(value.fixtures, slot.fixtures);
  fits &= store(value.target, slot.target);
  fits &= store(value.approach, slot.approach);
  fits &= store(value.radius, slot.radius);
  fits &= store(value.slope, slot.slope);
  fits &= store(value.speed, slot.speed);
  fits &= store(value.separation, slot.separation);
  fits &= store(value.friction, slot.friction);
  fits &= store(value.wrap, slot.wrap);
  fits &= store(value.master_damping, slot.master_damping);
  return fits;
}

void load(const GuideParametersSlot& slot, GuideParameters& value) {
  load(slot.period, value.period);
  load(slot.scale, value.scale);
  load(slot.max_age, value.max_age);
  load(slot.sighting_age, value.sighting_age);
  load(slot.registration_age, value.registration_age);
  load(slot.operator_age, value.operator_age);
  load(slot.enable_at_start, value.enable_at_start);
  load(slot.preparation_limit, value.preparation_limit);
  load(slot.fixtures, value.fixtures);
  load(slot.target, value.target);
  load(slot.approach, value.approach);
  load(slot.radius, value.radius);
  load(slot.slope, value.slope);
  load(slot.speed, value.speed);
  load(slot.separation, value.separation);
  load(slot.friction, value.friction);
  load(slot.wrap, value.wrap);
  load(slot.master_damping, value.master_damping);
}

bool isValid(const GuideParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.scale, 0.01, 10)) return suture::refusedAt(path, "scale");
  if (!isValid(slot.target, path)) return suture::refusedAt(path, "target");
  if (!isValid(slot.approach, path)) return suture::refusedAt(path, "approach");
  if (!suture::inRange(slot.radius, 0.0001, 0.1)) return suture::refusedAt(path, "radius");
  if (!suture::inRange(slot.slope, 0, 1)) return suture::refusedAt(path, "slope");
  if (!suture::inRange(slot.speed, 0.001, 1)) return suture::refusedAt(path, "speed");
  if (!suture::inRange(slot.separation, 0, 0.1)) return suture::refusedAt(path, "separation");
  if (!suture::inRange(slot.friction, 0, 1)) return suture::refusedAt(path, "friction");
  if (!suture::inRange(slot.wrap, 0, 100)) return suture::refusedAt(path, "wrap");
  return suture::inRange(slot.master_damping, 0, 1000) || suture::refusedAt(path, "master_damping");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, GuideParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("scale", value.scale, 0.01, 10);
  reader.field("max_age", value.max_age);
  reader.field("sighting_age", value.sighting_age);
  reader.field("registration_age", value.registration_age);
  reader.field("operator_age", value.operator_age);
  reader.field("enable_at_start", value.enable_at_start);
  reader.field("preparation_limit", value.preparation_limit);
  reader.field("fixtures", value.fixtures);
  reader.field("target", value.target);
  reader.field("approach", value.approach);
  reader.field("radius", value.radius, 0.0001, 0.1);
  reader.field("slope", value.slope, 0, 1);
  reader.field("speed", value.speed, 0.001, 1);
  reader.field("separation", value.separation, 0, 0.1);
  reader.field("friction", value.friction, 0, 1);
  reader.field("wrap", value.wrap, 0, 100);
  reader.field("master_damping", value.master_damping, 0, 1000);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::KnotGuide>() {
  return {"KnotGuide", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::GuideParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::KnotGuide(values));
            makeOptional(*component, {"Pedals", "Presence"});
            return component;
          }};
}

}  // namespace suture
