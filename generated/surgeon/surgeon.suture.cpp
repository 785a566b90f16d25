// Written by suturec from surgeon/surgeon.h. Do not edit.
#include "surgeon/surgeon.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "surgeon/surgeon.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SurgeonParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(SurgeonParameters::amplitude), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::turn), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::frequency), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::opening), double>);
static_assert(std::is_same_v<decltype(SurgeonParameters::ramp), double>);

}  // namespace

bool store(const SurgeonParameters& value, SurgeonParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.amplitude, slot.amplitude);
  fits &= store(value.turn, slot.turn);
  fits &= store(value.frequency, slot.frequency);
  fits &= store(value.opening, slot.opening);
  fits &= store(value.ramp, slot.ramp);
  return fits;
}

void load(const SurgeonParametersSlot& slot, SurgeonParameters& value) {
  load(slot.period, value.period);
  load(slot.amplitude, value.amplitude);
  load(slot.turn, value.turn);
  load(slot.frequency, value.frequency);
  load(slot.opening, value.opening);
  load(slot.ramp, value.ramp);
}

// --- between slots and Cap'n Proto

void toWire(const SurgeonParametersSlot& slot, wire::SurgeonParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setAmplitude(slot.amplitude);
  out.setTurn(slot.turn);
  out.setFrequency(slot.frequency);
  out.setOpening(slot.opening);
  out.setRamp(slot.ramp);
}

suture::Errc fromWire(wire::SurgeonParameters::Reader in, SurgeonParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.amplitude = in.getAmplitude();
  slot.turn = in.getTurn();
  slot.frequency = in.getFrequency();
  slot.opening = in.getOpening();
  slot.ramp = in.getRamp();
  return suture::Errc{};
}

bool isValid(const SurgeonParametersSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.amplitude, 0, 0.2)) return suture::refusedAt(path, "amplitude");
  if (!suture::rpc::inRange(slot.turn, 0, 1)) return suture::refusedAt(path, "turn");
  if (!suture::rpc::inRange(slot.frequency, 0.001, 10)) return suture::refusedAt(path, "frequency");
  if (!suture::rpc::inRange(slot.opening, 0, 1.047)) return suture::refusedAt(path, "opening");
  return suture::rpc::inRange(slot.ramp, 0.1, 100) || suture::refusedAt(path, "ramp");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, SurgeonParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("amplitude", value.amplitude, 0, 0.2);
  reader.field("turn", value.turn, 0, 1);
  reader.field("frequency", value.frequency, 0.001, 10);
  reader.field("opening", value.opening, 0, 1.047);
  reader.field("ramp", value.ramp, 0.1, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SurgeonParameters& value) {
  return rpc::encodeAs<robots::wire::SurgeonParameters, robots::SurgeonParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::SurgeonParameters& value) {
  return rpc::decodeAs<robots::wire::SurgeonParameters,
                       robots::SurgeonParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::Surgeon>() {
  return {"Surgeon", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::SurgeonParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Surgeon(values));
            makeOptional(*component, {"Teleoperation", "Hand"});
            return component;
          }};
}

}  // namespace suture
