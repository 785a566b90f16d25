// Written by suturec from 03_own_data_type/camera.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "03_own_data_type/camera.h"
#include "03_own_data_type/observation.suture.h"
#include "03_own_data_type/tracker.suture.h"

namespace suture {
class JsonReader;
}

namespace tracking {

/// The deployment file gives these as JSON, including the whole observation.
struct CameraParametersSlot {
  ObservationSlot first;
  double turn_rate;  // rad/s
};

bool store(const CameraParameters& value, CameraParametersSlot& slot);
void load(const CameraParametersSlot& slot, CameraParameters& value);
void reserve(const CameraParametersSlot*, CameraParameters& value);

bool isValid(const CameraParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, CameraParameters& value);

}  // namespace tracking

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const tracking::CameraParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, tracking::CameraParameters& value);

template <>
ComponentClass componentClass<tracking::Camera>();

}  // namespace suture
