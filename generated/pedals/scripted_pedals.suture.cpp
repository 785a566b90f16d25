// Written by suturec from pedals/scripted_pedals.h. Do not edit.
#include "pedals/scripted_pedals.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "pedals/scripted_pedals.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::clutch_after),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::clutch_for),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::leave_after),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::leave_for),
                             std::chrono::nanoseconds>);

}  // namespace

bool store(const ScriptedPedalsParameters& value, ScriptedPedalsParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.clutch_after, slot.clutch_after);
  fits &= store(value.clutch_for, slot.clutch_for);
  fits &= store(value.leave_after, slot.leave_after);
  fits &= store(value.leave_for, slot.leave_for);
  return fits;
}

void load(const ScriptedPedalsParametersSlot& slot, ScriptedPedalsParameters& value) {
  load(slot.period, value.period);
  load(slot.clutch_after, value.clutch_after);
  load(slot.clutch_for, value.clutch_for);
  load(slot.leave_after, value.leave_after);
  load(slot.leave_for, value.leave_for);
}

// --- between slots and Cap'n Proto

void toWire(const ScriptedPedalsParametersSlot& slot, wire::ScriptedPedalsParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setClutchAfter(slot.clutch_after);
  out.setClutchFor(slot.clutch_for);
  out.setLeaveAfter(slot.leave_after);
  out.setLeaveFor(slot.leave_for);
}

suture::Errc fromWire(wire::ScriptedPedalsParameters::Reader in, ScriptedPedalsParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.clutch_after = in.getClutchAfter();
  slot.clutch_for = in.getClutchFor();
  slot.leave_after = in.getLeaveAfter();
  slot.leave_for = in.getLeaveFor();
  return suture::Errc{};
}

bool isValid(const ScriptedPedalsParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, ScriptedPedalsParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("clutch_after", value.clutch_after);
  reader.field("clutch_for", value.clutch_for);
  reader.field("leave_after", value.leave_after);
  reader.field("leave_for", value.leave_for);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ScriptedPedalsParameters& value) {
  return rpc::encodeAs<robots::wire::ScriptedPedalsParameters,
                       robots::ScriptedPedalsParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::ScriptedPedalsParameters& value) {
  return rpc::decodeAs<robots::wire::ScriptedPedalsParameters,
                       robots::ScriptedPedalsParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::ScriptedPedals>() {
  return {"ScriptedPedals", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::ScriptedPedalsParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::ScriptedPedals(values));
          }};
}

}  // namespace suture
