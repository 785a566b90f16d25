// Written by suturec from recorder/knot_recorder.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "recorder/knot_recorder.h"
#include "guidance/guidance.suture.h"
#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/knot_vision.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct KnotRecorderParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  suture::BoundedText<255> file;
};

bool store(const KnotRecorderParameters& value, KnotRecorderParametersSlot& slot);
void load(const KnotRecorderParametersSlot& slot, KnotRecorderParameters& value);
void reserve(const KnotRecorderParametersSlot*, KnotRecorderParameters& value);

bool isValid(const KnotRecorderParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, KnotRecorderParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotRecorderParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotRecorderParameters& value);

template <>
ComponentClass componentClass<robots::KnotRecorder>();

}  // namespace suture
