// Written by suturec from assistant/assistant.h. Do not edit.
#include "assistant/assistant.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
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
ComponentClass componentClass<robots::Assistant>() {
  return {"Assistant", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::AssistantParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Assistant(values));
            makeOptional(*component, {"Console", "Left", "Right", "Guidance"});
            return component;
          }};
}

}  // namespace suture
