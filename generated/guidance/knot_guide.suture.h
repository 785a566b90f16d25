// Written by suturec from guidance/knot_guide.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "guidance/knot_guide.h"
#include "guidance/guidance.suture.h"
#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"
#include "registration/registration.suture.h"
#include "vision/knot_vision.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct GuideParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double scale;
  std::int64_t max_age;            // std::chrono::nanoseconds, ns
  std::int64_t sighting_age;       // std::chrono::nanoseconds, ns
  std::int64_t registration_age;   // std::chrono::nanoseconds, ns
  std::int64_t operator_age;       // std::chrono::nanoseconds, ns
  std::uint8_t enable_at_start;    // bool
  std::int64_t preparation_limit;  // std::chrono::nanoseconds, ns
  std::uint8_t fixtures;           // bool
  std::array<double, 3> target;    // Eigen::Vector3d, m
  std::array<double, 3> approach;  // Eigen::Vector3d
  double radius;                   // m
  double slope;
  double speed;       // m/s
  double separation;  // m
  double friction;
  double wrap;            // rad
  double master_damping;  // N.s/m
};

bool store(const GuideParameters& value, GuideParametersSlot& slot);
void load(const GuideParametersSlot& slot, GuideParameters& value);

bool isValid(const GuideParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, GuideParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::GuideParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::GuideParameters& value);

template <>
ComponentClass componentClass<robots::KnotGuide>();

}  // namespace suture
