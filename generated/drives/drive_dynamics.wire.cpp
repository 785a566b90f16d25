// Written by suturec from drives/drive_dynamics.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "drives/drive_dynamics.capnp.h"
#include "drives/drive_dynamics.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::DriveDynamics wireDriveDynamics(std::uint8_t slot) {
  switch (static_cast<DriveDynamics>(slot)) {
    case DriveDynamics::Lag: return wire::DriveDynamics::LAG;
    case DriveDynamics::RigidBody: return wire::DriveDynamics::RIGID_BODY;
  }
  return wire::DriveDynamics{};
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

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::RigidBodyOptions& value) {
  return codec::encodeAs<robots::wire::RigidBodyOptions, robots::RigidBodyOptionsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::RigidBodyOptions& value) {
  return codec::decodeAs<robots::wire::RigidBodyOptions,
                         robots::RigidBodyOptionsSlot>(bytes, value);
}

}  // namespace suture
