// Written by suturec from drives/psm_drives.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "drives/psm_drives.capnp.h"
#include "drives/psm_drives.suture.h"

// Defined in drives/drive_dynamics.wire.cpp.
namespace robots {
wire::DriveDynamics wireDriveDynamics(std::uint8_t slot);
suture::Errc fromWire(wire::DriveDynamics in, std::uint8_t& slot);
void toWire(const RigidBodyOptionsSlot& slot, wire::RigidBodyOptions::Builder out);
suture::Errc fromWire(wire::RigidBodyOptions::Reader in, RigidBodyOptionsSlot& slot,
                      suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PsmDrivesParametersSlot& slot, wire::PsmDrivesParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setTimeConstant(slot.time_constant);
  out.setAngularRate(slot.angular_rate);
  out.setInsertionRate(slot.insertion_rate);
  out.setJawRate(slot.jaw_rate);
  out.setPermit(slot.permit);
  out.setDynamics(wireDriveDynamics(slot.dynamics));
  toWire(slot.rigid_body, out.initRigidBody());
}

suture::Errc fromWire(wire::PsmDrivesParameters::Reader in, PsmDrivesParametersSlot& slot,
                      suture::Duration shift) {
  slot.period = in.getPeriod();
  slot.time_constant = in.getTimeConstant();
  slot.angular_rate = in.getAngularRate();
  slot.insertion_rate = in.getInsertionRate();
  slot.jaw_rate = in.getJawRate();
  slot.permit = in.getPermit();
  return suture::codec::firstError({
      fromWire(in.getDynamics(), slot.dynamics),
      fromWire(in.getRigidBody(), slot.rigid_body, shift),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::PsmDrivesParameters& value) {
  return codec::encodeAs<robots::wire::PsmDrivesParameters, robots::PsmDrivesParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::PsmDrivesParameters& value) {
  return codec::decodeAs<robots::wire::PsmDrivesParameters,
                         robots::PsmDrivesParametersSlot>(bytes, value);
}

}  // namespace suture
