// Written by suturec from person/keyboard.h. Do not edit.
#include "person/keyboard.suture.h"

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
static_assert(std::is_same_v<decltype(KeyboardParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(KeyboardParameters::terminal), std::string>);
static_assert(std::is_same_v<decltype(KeyboardParameters::speed), double>);
static_assert(std::is_same_v<decltype(KeyboardParameters::turning_speed), double>);
static_assert(std::is_same_v<decltype(KeyboardParameters::opening), double>);
static_assert(std::is_same_v<decltype(KeyboardParameters::hold), std::chrono::nanoseconds>);

}  // namespace

bool store(const KeyboardParameters& value, KeyboardParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.terminal, slot.terminal);
  fits &= store(value.speed, slot.speed);
  fits &= store(value.turning_speed, slot.turning_speed);
  fits &= store(value.opening, slot.opening);
  fits &= store(value.hold, slot.hold);
  return fits;
}

void load(const KeyboardParametersSlot& slot, KeyboardParameters& value) {
  load(slot.period, value.period);
  load(slot.terminal, value.terminal);
  load(slot.speed, value.speed);
  load(slot.turning_speed, value.turning_speed);
  load(slot.opening, value.opening);
  load(slot.hold, value.hold);
}

void reserve(const KeyboardParametersSlot*, KeyboardParameters& value) {
  suture::reserveFor<decltype(KeyboardParametersSlot::terminal)>(value.terminal);
}

bool isValid(const KeyboardParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.speed, 0.001, 0.25)) return suture::refusedAt(path, "speed");
  if (!suture::inRange(slot.turning_speed, 0.01, 2)) {
    return suture::refusedAt(path, "turning_speed");
  }
  return suture::inRange(slot.opening, 0, 1.047) || suture::refusedAt(path, "opening");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, KeyboardParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("terminal", value.terminal);
  reader.field("speed", value.speed, 0.001, 0.25);
  reader.field("turning_speed", value.turning_speed, 0.01, 2);
  reader.field("opening", value.opening, 0, 1.047);
  reader.field("hold", value.hold);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Keyboard>() {
  return {"Keyboard", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::KeyboardParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Keyboard(values));
            makeOptional(*component, {"Teleoperation", "Hand"});
            return component;
          }};
}

}  // namespace suture
