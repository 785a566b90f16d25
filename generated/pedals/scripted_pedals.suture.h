// Written by suturec from pedals/scripted_pedals.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "pedals/scripted_pedals.h"
#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct ScriptedPedalsParametersSlot {
  std::int64_t period;        // std::chrono::nanoseconds, ns
  std::int64_t clutch_after;  // std::chrono::nanoseconds, ns
  std::int64_t clutch_for;    // std::chrono::nanoseconds, ns
  std::int64_t leave_after;   // std::chrono::nanoseconds, ns
  std::int64_t leave_for;     // std::chrono::nanoseconds, ns
};

bool store(const ScriptedPedalsParameters& value, ScriptedPedalsParametersSlot& slot);
void load(const ScriptedPedalsParametersSlot& slot, ScriptedPedalsParameters& value);

bool isValid(const ScriptedPedalsParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, ScriptedPedalsParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::ScriptedPedalsParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::ScriptedPedalsParameters& value);

template <>
ComponentClass componentClass<robots::ScriptedPedals>();

}  // namespace suture
