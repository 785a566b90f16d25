// Written by suturec from guidance/knot_guide.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "guidance/knot_guide.capnp.h"
#include "guidance/knot_guide.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const GuideParametersSlot& slot, wire::GuideParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setScale(slot.scale);
  out.setMaxAge(slot.max_age);
  out.setSightingAge(slot.sighting_age);
  out.setRegistrationAge(slot.registration_age);
  out.setOperatorAge(slot.operator_age);
  out.setEnableAtStart(slot.enable_at_start != 0);
  out.setPreparationLimit(slot.preparation_limit);
  out.setFixtures(slot.fixtures != 0);
  toWire(slot.target, out.initTarget());
  toWire(slot.approach, out.initApproach());
  out.setRadius(slot.radius);
  out.setSlope(slot.slope);
  out.setSpeed(slot.speed);
  out.setSeparation(slot.separation);
  out.setFriction(slot.friction);
  out.setWrap(slot.wrap);
  out.setMasterDamping(slot.master_damping);
}

suture::Errc fromWire(wire::GuideParameters::Reader in, GuideParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.scale = in.getScale();
  slot.max_age = in.getMaxAge();
  slot.sighting_age = in.getSightingAge();
  slot.registration_age = in.getRegistrationAge();
  slot.operator_age = in.getOperatorAge();
  slot.enable_at_start = in.getEnableAtStart();
  slot.preparation_limit = in.getPreparationLimit();
  slot.fixtures = in.getFixtures();
  slot.radius = in.getRadius();
  slot.slope = in.getSlope();
  slot.speed = in.getSpeed();
  slot.separation = in.getSeparation();
  slot.friction = in.getFriction();
  slot.wrap = in.getWrap();
  slot.master_damping = in.getMasterDamping();
  return suture::codec::firstError({
      in.hasTarget() ? fromWire(in.getTarget(), slot.target)
          : suture::codec::fromDefault(GuideParameters().target, slot.target),
      in.hasApproach() ? fromWire(in.getApproach(), slot.approach)
          : suture::codec::fromDefault(GuideParameters().approach, slot.approach),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GuideParameters& value) {
  return codec::encodeAs<robots::wire::GuideParameters, robots::GuideParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::GuideParameters& value) {
  return codec::decodeAs<robots::wire::GuideParameters, robots::GuideParametersSlot>(bytes, value);
}

}  // namespace suture
