// Written by suturec from strand/strand_simulation.h. Do not edit.
#include "strand/strand_simulation.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "strand/strand_simulation.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(StrandParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(StrandParameters::length), double>);
static_assert(std::is_same_v<decltype(StrandParameters::friction), double>);
static_assert(std::is_same_v<decltype(StrandParameters::wrap), double>);

}  // namespace

bool store(const StrandParameters& value, StrandParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.length, slot.length);
  fits &= store(value.friction, slot.friction);
  fits &= store(value.wrap, slot.wrap);
  return fits;
}

void load(const StrandParametersSlot& slot, StrandParameters& value) {
  load(slot.period, value.period);
  load(slot.length, value.length);
  load(slot.friction, value.friction);
  load(slot.wrap, value.wrap);
}

// --- between slots and Cap'n Proto

void toWire(const StrandParametersSlot& slot, wire::StrandParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setLength(slot.length);
  out.setFriction(slot.friction);
  out.setWrap(slot.wrap);
}

suture::Errc fromWire(wire::StrandParameters::Reader in, StrandParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.length = in.getLength();
  slot.friction = in.getFriction();
  slot.wrap = in.getWrap();
  return suture::Errc{};
}

bool isValid(const StrandParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.length, 0.02, 1)) return suture::refusedAt(path, "length");
  if (!suture::rpc::inRange(slot.friction, 0, 1)) return suture::refusedAt(path, "friction");
  return suture::rpc::inRange(slot.wrap, 0, 100) || suture::refusedAt(path, "wrap");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, StrandParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("length", value.length, 0.02, 1);
  reader.field("friction", value.friction, 0, 1);
  reader.field("wrap", value.wrap, 0, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StrandParameters& value) {
  return rpc::encodeAs<robots::wire::StrandParameters, robots::StrandParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StrandParameters& value) {
  return rpc::decodeAs<robots::wire::StrandParameters, robots::StrandParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::StrandSimulation>() {
  return {"StrandSimulation", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::StrandParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::StrandSimulation(values));
          }};
}

}  // namespace suture
