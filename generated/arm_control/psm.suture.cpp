// Written by suturec from arm_control/psm.h. Do not edit.
#include "arm_control/psm.suture.h"

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
static_assert(std::is_same_v<decltype(PsmParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(PsmParameters::angular_rate), double>);
static_assert(std::is_same_v<decltype(PsmParameters::home_insertion), double>);
static_assert(std::is_same_v<decltype(PsmParameters::following_error), double>);
static_assert(std::is_same_v<decltype(PsmParameters::insertion_rate), double>);
static_assert(std::is_same_v<decltype(PsmParameters::insertion_following_error), double>);
static_assert(std::is_same_v<decltype(PsmParameters::angular_acceleration), double>);
static_assert(std::is_same_v<decltype(PsmParameters::insertion_acceleration), double>);
static_assert(std::is_same_v<decltype(PsmParameters::jaw_acceleration), double>);
static_assert(std::is_same_v<decltype(PsmParameters::jaw_rate), double>);
static_assert(std::is_same_v<decltype(PsmParameters::jump_factor), double>);
static_assert(std::is_same_v<decltype(PsmParameters::overload_time), double>);
static_assert(std::is_same_v<decltype(PsmParameters::servo_horizon), double>);

}  // namespace

bool store(const PsmParameters& value, PsmParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.angular_rate, slot.angular_rate);
  fits &= store(value.home_insertion, slot.home_insertion);
  fits &= store(value.following_error, slot.following_error);
  fits &= store(value.insertion_rate, slot.insertion_rate);
  fits &= store(value.insertion_following_error, slot.insertion_following_error);
  fits &= store(value.angular_acceleration, slot.angular_acceleration);
  fits &= store(value.insertion_acceleration, slot.insertion_acceleration);
  fits &= store(value.jaw_acceleration, slot.jaw_acceleration);
  fits &= store(value.jaw_rate, slot.jaw_rate);
  fits &= store(value.jump_factor, slot.jump_factor);
  fits &= store(value.overload_time, slot.overload_time);
  fits &= store(value.servo_horizon, slot.servo_horizon);
  return fits;
}

void load(const PsmParametersSlot& slot, PsmParameters& value) {
  load(slot.period, value.period);
  load(slot.angular_rate, value.angular_rate);
  load(slot.home_insertion, value.home_insertion);
  load(slot.following_error, value.following_error);
  load(slot.insertion_rate, value.insertion_rate);
  load(slot.insertion_following_error, value.insertion_following_error);
  load(slot.angular_acceleration, value.angular_acceleration);
  load(slot.insertion_acceleration, value.insertion_acceleration);
  load(slot.jaw_acceleration, value.jaw_acceleration);
  load(slot.jaw_rate, value.jaw_rate);
  load(slot.jump_factor, value.jump_factor);
  load(slot.overload_time, value.overload_time);
  load(slot.servo_horizon, value.servo_horizon);
}

bool isValid(const PsmParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.angular_rate, 0.01, 20)) return suture::refusedAt(path, "angular_rate");
  if (!suture::inRange(slot.home_insertion, 0, 0.24)) {
    return suture::refusedAt(path, "home_insertion");
  }
  if (!suture::inRange(slot.following_error, 0.001, 10)) {
    return suture::refusedAt(path, "following_error");
  }
  if (!suture::inRange(slot.insertion_rate, 0.001, 2)) {
    return suture::refusedAt(path, "insertion_rate");
  }
  if (!suture::inRange(slot.insertion_following_error, 0.0001, 1)) {
    return suture::refusedAt(path, "insertion_following_error");
  }
  if (!suture::inRange(slot.angular_acceleration, 0.1, 1000)) {
    return suture::refusedAt(path, "angular_acceleration");
  }
  if (!suture::inRange(slot.insertion_acceleration, 0.01, 100)) {
    return suture::refusedAt(path, "insertion_acceleration");
  }
  if (!suture::inRange(slot.jaw_acceleration, 0.1, 10000)) {
    return suture::refusedAt(path, "jaw_acceleration");
  }
  if (!suture::inRange(slot.jaw_rate, 0.01, 50)) return suture::refusedAt(path, "jaw_rate");
  if (!suture::inRange(slot.jump_factor, 1, 1000)) return suture::refusedAt(path, "jump_factor");
  if (!suture::inRange(slot.overload_time, 0.001, 10)) {
    return suture::refusedAt(path, "overload_time");
  }
  return suture::inRange(slot.servo_horizon, 0.001, 10) || suture::refusedAt(path, "servo_horizon");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, PsmParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("angular_rate", value.angular_rate, 0.01, 20);
  reader.field("home_insertion", value.home_insertion, 0, 0.24);
  reader.field("following_error", value.following_error, 0.001, 10);
  reader.field("insertion_rate", value.insertion_rate, 0.001, 2);
  reader.field("insertion_following_error", value.insertion_following_error, 0.0001, 1);
  reader.field("angular_acceleration", value.angular_acceleration, 0.1, 1000);
  reader.field("insertion_acceleration", value.insertion_acceleration, 0.01, 100);
  reader.field("jaw_acceleration", value.jaw_acceleration, 0.1, 10000);
  reader.field("jaw_rate", value.jaw_rate, 0.01, 50);
  reader.field("jump_factor", value.jump_factor, 1, 1000);
  reader.field("overload_time", value.overload_time, 0.001, 10);
  reader.field("servo_horizon", value.servo_horizon, 0.001, 10);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Psm>() {
  return {"Psm", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::PsmParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Psm(values));
          }};
}

}  // namespace suture
