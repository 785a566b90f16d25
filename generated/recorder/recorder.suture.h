// Written by suturec from recorder/recorder.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "recorder/recorder.h"
#include "arm/arm.suture.h"
#include "coordinator/emergency_stop.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct RecorderParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedText<255> file;
};

bool store(const RecorderParameters& value, RecorderParametersSlot& slot);
void load(const RecorderParametersSlot& slot, RecorderParameters& value);
void reserve(const RecorderParametersSlot*, RecorderParameters& value);

bool isValid(const RecorderParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, RecorderParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::RecorderParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::RecorderParameters& value);

template <>
ComponentClass componentClass<robots::Recorder>();

}  // namespace suture
