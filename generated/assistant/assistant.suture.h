// Written by suturec from assistant/assistant.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "assistant/assistant.h"
#include "console/console.suture.h"
#include "coordinator/emergency_stop.suture.h"
#include "guidance/guidance.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct AssistantParametersSlot {
  std::int64_t period;         // std::chrono::nanoseconds, ns
  std::int64_t press_after;    // std::chrono::nanoseconds, ns
  std::int64_t release_after;  // std::chrono::nanoseconds, ns
  std::int64_t patience;       // std::chrono::nanoseconds, ns
};

bool store(const AssistantParameters& value, AssistantParametersSlot& slot);
void load(const AssistantParametersSlot& slot, AssistantParameters& value);

bool isValid(const AssistantParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, AssistantParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AssistantParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::AssistantParameters& value);

template <>
ComponentClass componentClass<robots::Assistant>();

}  // namespace suture
