// Written by suturec from person/gamepad.h. Do not edit.
#include "person/gamepad.suture.h"

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
static_assert(std::is_same_v<decltype(GamepadParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(GamepadParameters::file), std::string>);
static_assert(std::is_same_v<decltype(GamepadParameters::stick), AxisRange>);
static_assert(std::is_same_v<decltype(GamepadParameters::trigger), AxisRange>);
static_assert(std::is_same_v<decltype(GamepadParameters::dead_zone), double>);
static_assert(std::is_same_v<decltype(GamepadParameters::speed), double>);
static_assert(std::is_same_v<decltype(GamepadParameters::turning_speed), double>);
static_assert(std::is_same_v<decltype(GamepadParameters::opening), double>);
static_assert(std::is_same_v<decltype(GamepadParameters::retry), std::chrono::nanoseconds>);

}  // namespace

bool store(const GamepadParameters& value, GamepadParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.file, slot.file);
  fits &= store(value.stick, slot.stick);
  fits &= store(value.trigger, slot.trigger);
  fits &= store(value.dead_zone, slot.dead_zone);
  fits &= store(value.speed, slot.speed);
  fits &= store(value.turning_speed, slot.turning_speed);
  fits &= store(value.opening, slot.opening);
  fits &= store(value.retry, slot.retry);
  return fits;
}

void load(const GamepadParametersSlot& slot, GamepadParameters& value) {
  load(slot.period, value.period);
  load(slot.file, value.file);
  load(slot.stick, value.stick);
  load(slot.trigger, value.trigger);
  load(slot.dead_zone, value.dead_zone);
  load(slot.speed, value.speed);
  load(slot.turning_speed, value.turning_speed);
  load(slot.opening, value.opening);
  load(slot.retry, value.retry);
}

void reserve(const GamepadParametersSlot*, GamepadParameters& value) {
  suture::reserveFor<decltype(GamepadParametersSlot::file)>(value.file);
}

bool isValid(const GamepadParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.stick, path)) return suture::refusedAt(path, "stick");
  if (!isValid(slot.trigger, path)) return suture::refusedAt(path, "trigger");
  if (!suture::inRange(slot.dead_zone, 0.01, 0.9)) return suture::refusedAt(path, "dead_zone");
  if (!suture::inRange(slot.speed, 0.001, 0.25)) return suture::refusedAt(path, "speed");
  if (!suture::inRange(slot.turning_speed, 0.01, 2)) {
    return suture::refusedAt(path, "turning_speed");
  }
  return suture::inRange(slot.opening, 0, 1.047) || suture::refusedAt(path, "opening");
}

}  // namespace robots

// Defined in person/axis_range.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, AxisRange& value);
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, GamepadParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("file", value.file);
  reader.field("stick", value.stick);
  reader.field("trigger", value.trigger);
  reader.field("dead_zone", value.dead_zone, 0.01, 0.9);
  reader.field("speed", value.speed, 0.001, 0.25);
  reader.field("turning_speed", value.turning_speed, 0.01, 2);
  reader.field("opening", value.opening, 0, 1.047);
  reader.field("retry", value.retry);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Gamepad>() {
  return {"Gamepad", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::GamepadParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Gamepad(values));
            makeOptional(*component, {"Teleoperation", "Hand"});
            return component;
          }};
}

}  // namespace suture
