// Written by suturec from person/gamepad.h. Do not edit.
#include "person/gamepad.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "person/gamepad.capnp.h"

// Defined in person/axis_range.suture.cpp.
namespace robots {
void toWire(const AxisRangeSlot& slot, wire::AxisRange::Builder out);
suture::Errc fromWire(wire::AxisRange::Reader in, AxisRangeSlot& slot, suture::Duration shift);
bool isValid(const AxisRangeSlot& slot, suture::FieldPath* path);
}  // namespace robots

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const GamepadParametersSlot& slot, wire::GamepadParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
  toWire(slot.stick, out.initStick());
  toWire(slot.trigger, out.initTrigger());
  out.setDeadZone(slot.dead_zone);
  out.setSpeed(slot.speed);
  out.setTurningSpeed(slot.turning_speed);
  out.setOpening(slot.opening);
  out.setRetry(slot.retry);
}

suture::Errc fromWire(wire::GamepadParameters::Reader in, GamepadParametersSlot& slot,
                      suture::Duration shift) {
  slot.period = in.getPeriod();
  slot.dead_zone = in.getDeadZone();
  slot.speed = in.getSpeed();
  slot.turning_speed = in.getTurningSpeed();
  slot.opening = in.getOpening();
  slot.retry = in.getRetry();
  return suture::rpc::firstError({
      in.hasFile() ? fromWire(in.getFile(), slot.file)
          : suture::rpc::fromDefault(GamepadParameters().file, slot.file),
      in.hasStick() ? fromWire(in.getStick(), slot.stick, shift)
          : suture::rpc::fromDefault(GamepadParameters().stick, slot.stick),
      in.hasTrigger() ? fromWire(in.getTrigger(), slot.trigger, shift)
          : suture::rpc::fromDefault(GamepadParameters().trigger, slot.trigger),
  });
}

bool isValid(const GamepadParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.stick, path)) return suture::refusedAt(path, "stick");
  if (!isValid(slot.trigger, path)) return suture::refusedAt(path, "trigger");
  if (!suture::rpc::inRange(slot.dead_zone, 0.01, 0.9)) return suture::refusedAt(path, "dead_zone");
  if (!suture::rpc::inRange(slot.speed, 0.001, 0.25)) return suture::refusedAt(path, "speed");
  if (!suture::rpc::inRange(slot.turning_speed, 0.01, 2)) {
    return suture::refusedAt(path, "turning_speed");
  }
  return suture::rpc::inRange(slot.opening, 0, 1.047) || suture::refusedAt(path, "opening");
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
Result<std::vector<std::byte>> encode(const robots::GamepadParameters& value) {
  return rpc::encodeAs<robots::wire::GamepadParameters, robots::GamepadParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::GamepadParameters& value) {
  return rpc::decodeAs<robots::wire::GamepadParameters,
                       robots::GamepadParametersSlot>(bytes, value);
}

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
