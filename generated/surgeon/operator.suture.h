// Written by suturec from surgeon/operator.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "surgeon/operator.h"
#include "guidance/guidance.suture.h"
#include "registration/registration.suture.h"
#include "vision/knot_vision.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

struct OperatorParametersSlot {
  std::int64_t period;           // std::chrono::nanoseconds, ns
  std::array<double, 3> target;  // Eigen::Vector3d, m
  double scale;
  double crossover_frequency;  // rad/s
  std::int64_t delay;          // std::chrono::nanoseconds, ns
  double remnant;
  std::uint32_t seed;
  double tremor;                // m
  double speed;                 // m/s
  std::int64_t picture_age;     // std::chrono::nanoseconds, ns
  std::uint8_t force_feedback;  // ForceFeedback
  double stiffness;             // N/m
  double damping;               // N.s/m
  std::uint8_t feel_fixtures;   // bool
  double resistance;            // N.s/m
  std::uint8_t passive;         // bool
  std::int64_t slave_age;       // std::chrono::nanoseconds, ns
};

bool store(const OperatorParameters& value, OperatorParametersSlot& slot);
void load(const OperatorParametersSlot& slot, OperatorParameters& value);

bool isKnownForceFeedback(std::uint8_t slot);
bool isValid(const OperatorParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, OperatorParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::OperatorParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::OperatorParameters& value);

template <>
ComponentClass componentClass<robots::Operator>();

}  // namespace suture
