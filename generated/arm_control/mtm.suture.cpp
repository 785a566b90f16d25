// Written by suturec from arm_control/mtm.h. Do not edit.
#include "arm_control/mtm.suture.h"

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
static_assert(std::is_same_v<decltype(MtmParameters::side), Side>);
static_assert(std::is_same_v<decltype(MtmParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(MtmParameters::angular_rate), double>);
static_assert(std::is_same_v<decltype(MtmParameters::angular_acceleration), double>);
static_assert(std::is_same_v<decltype(MtmParameters::following_error), double>);
static_assert(std::is_same_v<decltype(MtmParameters::jump_factor), double>);
static_assert(std::is_same_v<decltype(MtmParameters::overload_time), double>);
static_assert(std::is_same_v<decltype(MtmParameters::servo_horizon), double>);
static_assert(std::is_same_v<decltype(MtmParameters::gripper_closed), double>);
static_assert(std::is_same_v<decltype(MtmParameters::gripper_debounce), double>);

}  // namespace

bool store(const MtmParameters& value, MtmParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.side, slot.side);
  fits &= store(value.period, slot.period);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.following_error, slot.following_error);
  fits &= store(value.jump_factor, slot.jump_factor);
  fits &= store(value.overload_time, slot.overload_time);
  fits &= store(value.servo_horizon, slot.servo_horizon);
  fits &= store(value.gripper_closed, slot.gripper_closed);
  fits &= store(value.gripper_debounce, slot.gripper_debounce);
  return fits;
}

void load(const MtmParametersSlot& slot, MtmParameters& value) {
  load(slot.side, value.side);
  load(slot.period, value.period);
  load(slot.angular_rate, value.angular_rate);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.following_error, value.following_error);
  load(slot.jump_factor, value.jump_factor);
  load(slot.overload_time, value.overload_time);
  load(slot.servo_horizon, value.servo_horizon);
  load(slot.gripper_closed, value.gripper_closed);
  load(slot.gripper_debounce, value.gripper_debounce);
}

bool isValid(const MtmParametersSlot& slot, suture::FieldPath* path) {
  if (!isKnownSide(slot.side)) return suture::refusedAt(path, "side");
  if (!suture::inRange(slot.angular_rate, 0.01, 20)) return suture::refusedAt(path, "angular_rate");
  if (!suture::inRange(slot.angular_acceleration, 0.1, 1000)) {
    return suture::refusedAt(path, "angular_acceleration");
  }
  if (!suture::inRange(slot.following_error, 0.001, 10)) {
    return suture::refusedAt(path, "following_error");
  }
  if (!suture::inRange(slot.jump_factor, 1, 1000)) return suture::refusedAt(path, "jump_factor");
  if (!suture::inRange(slot.overload_time, 0.001, 10)) {
    return suture::refusedAt(path, "overload_time");
  }
  if (!suture::inRange(slot.servo_horizon, 0.001, 10)) {
    return suture::refusedAt(path, "servo_horizon");
  }
  if (!suture::inRange(slot.gripper_closed, -0.2, 1.05)) {
    return suture::refusedAt(path, "gripper_closed");
  }
  return suture::inRange(slot.gripper_debounce, 0, 1) ||
      suture::refusedAt(path, "gripper_debounce");
}

}  // namespace robots

namespace robots {

[[gnu::weak]] void fromJson(const suture::JsonReader& in, Side& value) {
  static constexpr Side kValues[] = {Side::Left, Side::Right};
  const int index = suture::enumeratorFromJson(in, {"Left", "Right"});
  if (index >= 0) value = kValues[index];
}

void fromJson(const suture::JsonReader& in, MtmParameters& value) {
  suture::JsonReader reader = in;
  reader.field("side", value.side);
  reader.field("period", value.period);
  reader.field("angular_rate", value.angular_rate, 0.01, 20);
  reader.field("angular_acceleration", value.angular_acceleration, 0.1, 1000);
  reader.field("following_error", value.following_error, 0.001, 10);
  reader.field("jump_factor", value.jump_factor, 1, 1000);
  reader.field("overload_time", value.overload_time, 0.001, 10);
  reader.field("servo_horizon", value.servo_horizon, 0.001, 10);
  reader.field("gripper_closed", value.gripper_closed, -0.2, 1.05);
  reader.field("gripper_debounce", value.gripper_debounce, 0, 1);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Mtm>() {
  return {"Mtm", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::MtmParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Mtm(values));
          }};
}

}  // namespace suture
