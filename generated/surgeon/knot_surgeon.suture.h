// Written by suturec from surgeon/knot_surgeon.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "surgeon/knot_surgeon.h"
#include "arm/arm.suture.h"
#include "guidance/guidance.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct KnotSurgeonParametersSlot {
  std::int64_t period;          // std::chrono::nanoseconds, ns
  std::array<double, 3> carry;  // Eigen::Vector3d, m
  double duration;              // s
  double sway;                  // m
  double sway_frequency;        // Hz
};

bool store(const KnotSurgeonParameters& value, KnotSurgeonParametersSlot& slot);
void load(const KnotSurgeonParametersSlot& slot, KnotSurgeonParameters& value);

bool isValid(const KnotSurgeonParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, KnotSurgeonParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::KnotSurgeonParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotSurgeonParameters& value);

template <>
ComponentClass componentClass<robots::KnotSurgeon>();

}  // namespace suture
