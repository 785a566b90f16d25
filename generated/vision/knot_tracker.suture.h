// Written by suturec from vision/knot_tracker.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "vision/knot_tracker.h"
#include "vision/knot_vision.suture.h"
#include "vision/stereo_images.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct TrackerParametersSlot {
  std::int64_t period;   // std::chrono::nanoseconds, ns
  std::int64_t max_age;  // std::chrono::nanoseconds, ns
  double acceleration;   // m/s2
};

bool store(const TrackerParameters& value, TrackerParametersSlot& slot);
void load(const TrackerParametersSlot& slot, TrackerParameters& value);

bool isValid(const TrackerParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, TrackerParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::TrackerParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::TrackerParameters& value);

template <>
ComponentClass componentClass<robots::KnotTracker>();

}  // namespace suture
