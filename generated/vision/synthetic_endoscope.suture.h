// Written by suturec from vision/synthetic_endoscope.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "vision/synthetic_endoscope.h"
#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/stereo_images.suture.h"

namespace suture {
class JsonReader;
}

namespace robots {

/// Blur, dropouts and latency are our own numbers, because none was found for an endoscope of this
/// kind.
struct EndoscopeParametersSlot {
  std::int64_t period;  // std::chrono::nanoseconds, ns
  double noise;
  double blur;  // px
  double dropout;
  std::int64_t latency;  // std::chrono::nanoseconds, ns
  double vergence;       // rad
};

bool store(const EndoscopeParameters& value, EndoscopeParametersSlot& slot);
void load(const EndoscopeParametersSlot& slot, EndoscopeParameters& value);

bool isValid(const EndoscopeParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, EndoscopeParameters& value);

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::EndoscopeParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, robots::EndoscopeParameters& value);

template <>
ComponentClass componentClass<robots::SyntheticEndoscope>();

}  // namespace suture
