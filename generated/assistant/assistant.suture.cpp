// Written by suturec from assistant/assistant.h. Do not edit.
#include "assistant/assistant.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "assistant/assistant.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(AssistantParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(AssistantParameters::press_after), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(AssistantParameters::release_after),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(AssistantParameters::patience), std::chrono::nanoseconds>);

}  // namespace

bool store(const AssistantParameters& value, AssistantParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.press_after, slot.press_after);
  fits &= store(value.release_after, slot.release_after);
  fits &= store(value.patience, slot.patience);
  return fits;
}

void load(const AssistantParametersSlot& slot, AssistantParameters& value) {
  load(slot.period, value.period);
  load(slot.press_after, value.press_after);
  load(slot.release_after, value.release_after);
  load(slot.patience, value.patience);
}

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

bool isValid(const AssistantParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, AssistantParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("press_after", value.press_after);
  reader.field("release_after", value.release_after);
  reader.field("patience", value.patience);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AssistantParameters& value) {
  return rpc::encodeAs<robots::wire::AssistantParameters, robots::AssistantParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::AssistantParameters& value) {
  return rpc::decodeAs<robots::wire::AssistantParameters,
                       robots::AssistantParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::Assistant>() {
  return {"Assistant", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::AssistantParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Assistant(values));
            makeOptional(*component, {"Left", "Right", "Guidance"});
            return component;
          }};
}

}  // namespace suture
