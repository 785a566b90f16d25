// Written by suturec from teleop/teleop.h. Do not edit.
#include "teleop/teleop.suture.h"

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
static_assert(std::is_same_v<decltype(TeleopParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::scale), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::max_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::enable_at_start), bool>);
static_assert(std::is_same_v<decltype(TeleopParameters::align), bool>);
static_assert(std::is_same_v<decltype(TeleopParameters::alignment_tolerance), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::release_master), bool>);
static_assert(std::is_same_v<decltype(TeleopParameters::preparation_limit),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::operator_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::registration_age),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::jaw_scale), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::jaw_offset), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::jaw_rate), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::jaw_ghost_rate), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::jaw_tolerance), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::master_side), Side>);
static_assert(std::is_same_v<decltype(TeleopParameters::slave_side), Side>);

}  // namespace

bool store(const TeleopParameters& value, TeleopParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.scale, slot.scale);
  fits &= store(value.max_age, slot.max_age);
  fits &= store(value.enable_at_start, slot.enable_at_start);
  fits &= store(value.align, slot.align);
  fits &= store(value.alignment_tolerance, slot.alignment_tolerance);
  fits &= store(value.release_master, slot.release_master);
  fits &= store(value.preparation_limit, slot.preparation_limit);
  fits &= store(value.operator_age, slot.operator_age);
  fits &= store(value.registration_age, slot.registration_age);
  fits &= store(value.jaw_scale, slot.jaw_scale);
  fits &= store(value.jaw_offset, slot.jaw_offset);
  fits &= store(value.jaw_rate, slot.jaw_rate);
  fits &= store(value.jaw_ghost_rate, slot.jaw_ghost_rate);
  fits &= store(value.jaw_tolerance, slot.jaw_tolerance);
  fits &= store(value.master_side, slot.master_side);
  fits &= store(value.slave_side, slot.slave_side);
  return fits;
}

void load(const TeleopParametersSlot& slot, TeleopParameters& value) {
  load(slot.period, value.period);
  load(slot.scale, value.scale);
  load(slot.max_age, value.max_age);
  load(slot.enable_at_start, value.enable_at_start);
  load(slot.align, value.align);
  load(slot.alignment_tolerance, value.alignment_tolerance);
  load(slot.release_master, value.release_master);
  load(slot.preparation_limit, value.preparation_limit);
  load(slot.operator_age, value.operator_age);
  load(slot.registration_age, value.registration_age);
  load(slot.jaw_scale, value.jaw_scale);
  load(slot.jaw_offset, value.jaw_offset);
  load(slot.jaw_rate, value.jaw_rate);
  load(slot.jaw_ghost_rate, value.jaw_ghost_rate);
  load(slot.jaw_tolerance, value.jaw_tolerance);
  load(slot.master_side, value.master_side);
  load(slot.slave_side, value.slave_side);
}

bool isValid(const TeleopParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::inRange(slot.scale, 0.01, 10)) return suture::refusedAt(path, "scale");
  if (!suture::inRange(slot.alignment_tolerance, 0.001, 1)) {
    return suture::refusedAt(path, "alignment_tolerance");
  }
  if (!suture::inRange(slot.jaw_scale, 0.01, 10)) return suture::refusedAt(path, "jaw_scale");
  if (!suture::inRange(slot.jaw_offset, -2, 2)) return suture::refusedAt(path, "jaw_offset");
  if (!suture::inRange(slot.jaw_rate, 0.01, 50)) return suture::refusedAt(path, "jaw_rate");
  if (!suture::inRange(slot.jaw_ghost_rate, 0.01, 50)) {
    return suture::refusedAt(path, "jaw_ghost_rate");
  }
  if (!suture::inRange(slot.jaw_tolerance, 0.001, 1)) {
    return suture::refusedAt(path, "jaw_tolerance");
  }
  if (!isKnownSide(slot.master_side)) return suture::refusedAt(path, "master_side");
  return isKnownSide(slot.slave_side) || suture::refusedAt(path, "slave_side");
}

}  // namespace robots

// Defined in arm_control/mtm.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, Side& value);
}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, TeleopParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("scale", value.scale, 0.01, 10);
  reader.field("max_age", value.max_age);
  reader.field("enable_at_start", value.enable_at_start);
  reader.field("align", value.align);
  reader.field("alignment_tolerance", value.alignment_tolerance, 0.001, 1);
  reader.field("release_master", value.release_master);
  reader.field("preparation_limit", value.preparation_limit);
  reader.field("operator_age", value.operator_age);
  reader.field("registration_age", value.registration_age);
  reader.field("jaw_scale", value.jaw_scale, 0.01, 10);
  reader.field("jaw_offset", value.jaw_offset, -2, 2);
  reader.field("jaw_rate", value.jaw_rate, 0.01, 50);
  reader.field("jaw_ghost_rate", value.jaw_ghost_rate, 0.01, 50);
  reader.field("jaw_tolerance", value.jaw_tolerance, 0.001, 1);
  reader.field("master_side", value.master_side);
  reader.field("slave_side", value.slave_side);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Teleop>() {
  return {"Teleop", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::TeleopParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Teleop(values));
            makeOptional(*component, {"Gripper", "Jaw", "Pedals", "Presence", "Registration"});
            return component;
          }};
}

}  // namespace suture
