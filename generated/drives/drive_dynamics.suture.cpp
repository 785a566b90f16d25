// Written by suturec from drives/drive_dynamics.h. Do not edit.
#include "drives/drive_dynamics.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "drives/drive_dynamics.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<std::underlying_type_t<DriveDynamics>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(DriveDynamics::Lag) == 0);
static_assert(static_cast<std::uint8_t>(DriveDynamics::RigidBody) == 1);
static_assert(std::is_same_v<decltype(RigidBodyOptions::gravity_compensation), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::quantisation), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::noise), double>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::seed), std::uint32_t>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::brakes), bool>);
static_assert(std::is_same_v<decltype(RigidBodyOptions::current_gain), double>);

}  // namespace

bool store(const RigidBodyOptions& value, RigidBodyOptionsSlot& slot) {
  bool fits = true;
  fits &= store(value.gravity_compensation, slot.gravity_compensation);
  fits &= store(value.quantisation, slot.quantisation);
  fits &= store(value.noise, slot.noise);
  fits &= store(value.seed, slot.seed);
  fits &= store(value.brakes, slot.brakes);
  fits &= store(value.current_gain, slot.current_gain);
  return fits;
}

void load(const RigidBodyOptionsSlot& slot, RigidBodyOptions& value) {
  load(slot.gravity_compensation, value.gravity_compensation);
  load(slot.quantisation, value.quantisation);
  load(slot.noise, value.noise);
  load(slot.seed, value.seed);
  load(slot.brakes, value.brakes);
  load(slot.current_gain, value.current_gain);
}

// --- between slots and Cap'n Proto

wire::DriveDynamics wireDriveDynamics(std::uint8_t slot) {
  switch (static_cast<DriveDynamics>(slot)) {
    case DriveDynamics::Lag: return wire::DriveDynamics::LAG;
    case DriveDynamics::RigidBody: return wire::DriveDynamics::RIGID_BODY;
  }
  return wire::DriveDynamics{};
}

bool isKnownDriveDynamics(std::uint8_t slot) {
  switch (static_cast<DriveDynamics>(slot)) {
    case DriveDynamics::Lag:
    case DriveDynamics::RigidBody:
      return true;
  }
  return false;
}

suture::Errc fromWire(wire::DriveDynamics in, std::uint8_t& slot) {
  switch (in) {
    case wire::DriveDynamics::LAG: return slot =
        static_cast<std::uint8_t>(DriveDynamics::Lag), suture::Errc{};
    case wire::DriveDynamics::RIGID_BODY: return slot =
        static_cast<std::uint8_t>(DriveDynamics::RigidBody), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const RigidBodyOptionsSlot& slot, wire::RigidBodyOptions::Builder out) {
  out.setGravityCompensation(slot.gravity_compensation != 0);
  out.setQuantisation(slot.quantisation != 0);
  out.setNoise(slot.noise);
  out.setSeed(slot.seed);
  out.setBrakes(slot.brakes != 0);
  out.setCurrentGain(slot.current_gain);
}

suture::Errc fromWire(wire::RigidBodyOptions::Reader in, RigidBodyOptionsSlot& slot,
                      suture::Duration) {
  slot.gravity_compensation = in.getGravityCompensation();
  slot.quantisation = in.getQuantisation();
  slot.noise = in.getNoise();
  slot.seed = in.getSeed();
  slot.brakes = in.getBrakes();
  slot.current_gain = in.getCurrentGain();
  return suture::Errc{};
}

bool isValid(const RigidBodyOptionsSlot& slot, suture::FieldPath* path) {
  if (!suture::rpc::inRange(slot.noise, 0, 1000)) return suture::refusedAt(path, "noise");
  return suture::rpc::inRange(slot.current_gain, 0.1, 100) ||
      suture::refusedAt(path, "current_gain");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, DriveDynamics& value) {
  static constexpr DriveDynamics kValues[] = {DriveDynamics::Lag, DriveDynamics::RigidBody};
  const int index = suture::enumeratorFromJson(in, {"Lag", "RigidBody"});
  if (index >= 0) value = kValues[index];
}

void fromJson(const suture::JsonReader& in, RigidBodyOptions& value) {
  suture::JsonReader reader = in;
  reader.field("gravity_compensation", value.gravity_compensation);
  reader.field("quantisation", value.quantisation);
  reader.field("noise", value.noise, 0, 1000);
  reader.field("seed", value.seed);
  reader.field("brakes", value.brakes);
  reader.field("current_gain", value.current_gain, 0.1, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::RigidBodyOptions& value) {
  return rpc::encodeAs<robots::wire::RigidBodyOptions, robots::RigidBodyOptionsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::RigidBodyOptions& value) {
  return rpc::decodeAs<robots::wire::RigidBodyOptions, robots::RigidBodyOptionsSlot>(bytes, value);
}

}  // namespace suture
