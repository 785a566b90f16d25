// Written by suturec from console/system_console.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "console/system_console.h"
#include "arm/arm.suture.h"
#include "console/console.suture.h"
#include "coordinator/emergency_stop.suture.h"
#include "guidance/guidance.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct SystemConsoleParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedList<suture::BoundedText<15>, 8> system;
  std::int64_t patience;            // std::chrono::nanoseconds, ns
  std::uint8_t bring_up_by_itself;  // bool
};

bool store(const SystemConsoleParameters& value, SystemConsoleParametersSlot& slot);
void load(const SystemConsoleParametersSlot& slot, SystemConsoleParameters& value);
void reserve(const SystemConsoleParametersSlot*, SystemConsoleParameters& value);

bool isValid(const SystemConsoleParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SystemConsoleParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SystemConsoleParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::SystemConsoleParameters& value);

template <>
ComponentClass componentClass<robots::SystemConsole>();

}  // namespace suture
