// Written by suturec from assistant/assistant.h. Do not edit.
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "assistant/assistant.capnp.h"
#include "assistant/assistant.suture.h"

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const AssistantParametersSlot& slot, wire::AssistantParameters::Builder out) {
  out.setPeriod(slot.period);
  out.setPressAfter(slot.press_after);
  out.setReleaseAfter(slot.release_after);
  out.setPatience(slot.patience);
}

suture::Errc fromWire(wire::AssistantParameters::Reader in, AssistantParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.press_after = in.getPressAfter();
  slot.release_after = in.getReleaseAfter();
  slot.patience = in.getPatience();
  return suture::Errc{};
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AssistantParameters& value) {
  return codec::encodeAs<robots::wire::AssistantParameters, robots::AssistantParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::AssistantParameters& value) {
  return codec::decodeAs<robots::wire::AssistantParameters,
                         robots::AssistantParametersSlot>(bytes, value);
}

}  // namespace suture
