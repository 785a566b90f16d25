// Written by suturec from teleop/teleop.h. Do not edit.
#include "teleop/teleop.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "teleop/teleop.capnp.h"

// Defined in robot_types/side.suture.cpp.
namespace robots {
wire::Side wireSide(std::uint8_t slot);
bool isKnownSide(std::uint8_t slot);
suture::Errc fromWire(wire::Side in, std::uint8_t& slot);
}  // namespace robots

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(TeleopParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::scale), double>);
static_assert(std::is_same_v<decltype(TeleopParameters::max_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TeleopParameters::enable_at_start), bool>);
static_assert(std::is_same_v<decltype(TeleopParameters::align), bool>);
static_assert(std::is_same_v<decltype(TeleopParameters::alignment_tolerance), double>);
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

// --- between slots and Cap'n Proto

void toWire(const TeleopParametersSlot& slot, wire::TeleopParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setScale(slot.scale);
  out.setMaxAge(slot.max_age);
  out.setEnableAtStart(slot.enable_at_start != 0);
  out.setAlign(slot.align != 0);
  out.setAlignmentTolerance(slot.alignment_tolerance);
  out.setPreparationLimit(slot.preparation_limit);
  out.setOperatorAge(slot.operator_age);
  out.setRegistrationAge(slot.registration_age);
  out.setJawScale(slot.jaw_scale);
  out.setJawOffset(slot.jaw_offset);
  out.setJawRate(slot.jaw_rate);
  out.setJawGhostRate(slot.jaw_ghost_rate);
  out.setJawTolerance(slot.jaw_tolerance);
  out.setMasterSide(wireSide(slot.master_side));
  out.setSlaveSide(wireSide(slot.slave_side));
}

suture::Errc fromWire(wire::TeleopParameters::Reader in, TeleopParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.scale = in.getScale();
  slot.max_age = in.getMaxAge();
  slot.enable_at_start = in.getEnableAtStart();
  slot.align = in.getAlign();
  slot.alignment_tolerance = in.getAlignmentTolerance();
  slot.preparation_limit = in.getPreparationLimit();
  slot.operator_age = in.getOperatorAge();
  slot.registration_age = in.getRegistrationAge();
  slot.jaw_scale = in.getJawScale();
  slot.jaw_offset = in.getJawOffset();
  slot.jaw_rate = in.getJawRate();
  slot.jaw_ghost_rate = in.getJawGhostRate();
  slot.jaw_tolerance = in.getJawTolerance();
  return suture::rpc::firstError({
      fromWire(in.getMasterSide(), slot.master_side),
      fromWire(in.getSlaveSide(), slot.slave_side),
  });
}

bool isValid(const TeleopParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.scale, 0.01, 10)) return suture::refusedAt(path, "scale");
  if (!suture::rpc::inRange(slot.alignment_tolerance, 0.001, 1)) {
    return suture::refusedAt(path, "alignment_tolerance");
  }
  if (!suture::rpc::inRange(slot.jaw_scale, 0.01, 10)) return suture::refusedAt(path, "jaw_scale");
  if (!suture::rpc::inRange(slot.jaw_offset, -2, 2)) return suture::refusedAt(path, "jaw_offset");
  if (!suture::rpc::inRange(slot.jaw_rate, 0.01, 50)) return suture::refusedAt(path, "jaw_rate");
  if (!suture::rpc::inRange(slot.jaw_ghost_rate, 0.01, 50)) {
    return suture::refusedAt(path, "jaw_ghost_rate");
  }
  if (!suture::rpc::inRange(slot.jaw_tolerance, 0.001, 1)) {
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
Result<std::vector<std::byte>> encode(const robots::TeleopParameters& value) {
  return rpc::encodeAs<robots::wire::TeleopParameters, robots::TeleopParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::TeleopParameters& value) {
  return rpc::decodeAs<robots::wire::TeleopParameters, robots::TeleopParametersSlot>(bytes, value);
}

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
