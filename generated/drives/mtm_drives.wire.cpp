// Written by suturec from drives/mtm_drives.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "drives/mtm_drives.capnp.h"
#include "drives/mtm_drives.suture.h"

// Defined in drives/drive_dynamics.wire.cpp.
namespace robots {
wire::DriveDynamics wireDriveDynamics(std::uint8_t slot);
suture::Errc fromWire(wire::DriveDynamics in, std::uint8_t& slot);
void toWire(const RigidBodyOptionsSlot& slot, wire::RigidBodyOptions::Builder out);
suture::Errc fromWire(wire::RigidBodyOptions::Reader in, RigidBodyOptionsSlot& slot,
                      suture::Duration shift);
}  // namespace robots

// Defined in robot_types/side.wire.cpp.
namespace robots {
wire::Side wireSide(std::uint8_t slot);
suture::Errc fromWire(wire::Side in, std::uint8_t& slot);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const MtmDrivesParametersSlot& slot, wire::MtmDrivesParameters::Builder out) {
  out.setSide(wireSide(slot.side));
  out.setPeriod(slot.period);
  out.setTimeConstant(slot.time_constant);
  out.setAngularRate(slot.angular_rate);
  out.setPermit(slot.permit);
  out.setDynamics(wireDriveDynamics(slot.dynamics));
  toWire(slot.rigid_body, out.initRigidBody());
}

suture::Errc fromWire(wire::MtmDrivesParameters::Reader in, MtmDrivesParametersSlot& slot,
                      suture::Duration shift) {
  slot.period = in.getPeriod();
  slot.time_constant = in.getTimeConstant();
  slot.angular_rate = in.getAngularRate();
  slot.permit = in.getPermit();
  return suture::codec::firstError({
      fromWire(in.getSide(), slot.side),
      fromWire(in.getDynamics(), slot.dynamics),
      fromWire(in.getRigidBody(), slot.rigid_body, shift),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::MtmDrivesParameters& value) {
  return codec::encodeAs<robots::wire::MtmDrivesParameters, robots::MtmDrivesParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::MtmDrivesParameters& value) {
  return codec::decodeAs<robots::wire::MtmDrivesParameters,
                         robots::MtmDrivesParametersSlot>(bytes, value);
}

}  // namespace suture
