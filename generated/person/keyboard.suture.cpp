// Written by suturec from person/keyboard.h. Do not edit.
#include "person/keyboard.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "person/keyboard.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const KeyboardParametersSlot& slot, wire::KeyboardParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.terminal, out.initTerminal(sizeOf(slot.terminal)));
  out.setSpeed(slot.speed);
  out.setTurningSpeed(slot.turning_speed);
  out.setOpening(slot.opening);
  out.setHold(slot.hold);
}

suture::Errc fromWire(wire::KeyboardParameters::Reader in, KeyboardParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.speed = in.getSpeed();
  slot.turning_speed = in.getTurningSpeed();
  slot.opening = in.getOpening();
  slot.hold = in.getHold();
  return in.hasTerminal() ? fromWire(in.getTerminal(), slot.terminal)
      : suture::rpc::fromDefault(KeyboardParameters().terminal, slot.terminal);
}

bool isValid(const KeyboardParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.speed, 0.001, 0.25)) return suture::refusedAt(path, "speed");
  if (!suture::rpc::inRange(slot.turning_speed, 0.01, 2)) {
    return suture::refusedAt(path, "turning_speed");
  }
  return suture::rpc::inRange(slot.opening, 0, 1.047) || suture::refusedAt(path, "opening");
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
Result<std::vector<std::byte>> encode(const robots::KeyboardParameters& value) {
  return rpc::encodeAs<robots::wire::KeyboardParameters, robots::KeyboardParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KeyboardParameters& value) {
  return rpc::decodeAs<robots::wire::KeyboardParameters,
                       robots::KeyboardParametersSlot>(bytes, value);
}

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
