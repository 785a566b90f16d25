// Written by suturec from surgeon/operator.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "surgeon/operator.capnp.h"
#include "surgeon/operator.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

wire::ForceFeedback wireForceFeedback(std::uint8_t slot) {
  switch (static_cast<ForceFeedback>(slot)) {
    case ForceFeedback::None: return wire::ForceFeedback::NONE;
    case ForceFeedback::PositionPosition: return wire::ForceFeedback::POSITION_POSITION;
  }
  return wire::ForceFeedback{};
}

suture::Errc fromWire(wire::ForceFeedback in, std::uint8_t& slot) {
  switch (in) {
    case wire::ForceFeedback::NONE: return slot =
        static_cast<std::uint8_t>(ForceFeedback::None), suture::Errc{};
    case wire::ForceFeedback::POSITION_POSITION: return slot =
        static_cast<std::uint8_t>(ForceFeedback::PositionPosition), suture::Errc{};
  }
  return suture::Errc::Invalid;
}

void toWire(const OperatorParametersSlot& slot, wire::OperatorParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.target, out.initTarget());
  out.setScale(slot.scale);
  out.setCrossoverFrequency(slot.crossover_frequency);
  out.setDelay(slot.delay);
  out.setRemnant(slot.remnant);
  out.setSeed(slot.seed);
  out.setTremor(slot.tremor);
  out.setSpeed(slot.speed);
  out.setPictureAge(slot.picture_age);
  out.setForceFeedback(wireForceFeedback(slot.force_feedback));
  out.setStiffness(slot.stiffness);
  out.setDamping(slot.damping);
  out.setFeelFixtures(slot.feel_fixtures != 0);
  out.setResistance(slot.resistance);
  out.setPassive(slot.passive != 0);
  out.setSlaveAge(slot.slave_age);
}

suture::Errc fromWire(wire::OperatorParameters::Reader in, OperatorParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.scale = in.getScale();
  slot.crossover_frequency = in.getCrossoverFrequency();
  slot.delay = in.getDelay();
  slot.remnant = in.getRemnant();
  slot.seed = in.getSeed();
  slot.tremor = in.getTremor();
  slot.speed = in.getSpeed();
  slot.picture_age = in.getPictureAge();
  slot.stiffness = in.getStiffness();
  slot.damping = in.getDamping();
  slot.feel_fixtures = in.getFeelFixtures();
  slot.resistance = in.getResistance();
  slot.passive = in.getPassive();
  slot.slave_age = in.getSlaveAge();
  return suture::codec::firstError({
      in.hasTarget() ? fromWire(in.getTarget(), slot.target)
          : suture::codec::fromDefault(OperatorParameters().target, slot.target),
      fromWire(in.getForceFeedback(), slot.force_feedback),
  });
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::OperatorParameters& value) {
  return codec::encodeAs<robots::wire::OperatorParameters, robots::OperatorParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::OperatorParameters& value) {
  return codec::decodeAs<robots::wire::OperatorParameters,
                         robots::OperatorParametersSlot>(bytes, value);
}

}  // namespace suture
