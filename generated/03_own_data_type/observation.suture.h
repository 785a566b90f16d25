// Written by suturec from 03_own_data_type/observation.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "03_own_data_type/observation.h"

namespace tracking {

struct MarkerSlot {
  std::uint32_t number;
  std::array<double, 3> position;  // Eigen::Vector3d, m
};

bool store(const Marker& value, MarkerSlot& slot);
void load(const MarkerSlot& slot, Marker& value);

/// An Observation is what a tracking camera knows of a surgical instrument at one moment, in the
/// camera's frame.
struct ObservationSlot {
  suture::BoundedText<31> instrument;
  std::uint8_t visibility;     // Visibility
  std::array<double, 12> tip;  // Eigen::Isometry3d, m
  suture::BoundedList<MarkerSlot, 8> markers;
  double jaw_angle;  // rad
};

bool store(const Observation& value, ObservationSlot& slot);
void load(const ObservationSlot& slot, Observation& value);
void reserve(const ObservationSlot*, Observation& value);

bool isKnownVisibility(std::uint8_t slot);
bool isValid(const MarkerSlot& slot, suture::FieldPath* path);
bool isValid(const ObservationSlot& slot, suture::FieldPath* path);

}  // namespace tracking

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const tracking::Marker& value);
template <>
Result<> decode(std::span<const std::byte> bytes, tracking::Marker& value);

template <>
Result<std::vector<std::byte>> encode(const tracking::Observation& value);
template <>
Result<> decode(std::span<const std::byte> bytes, tracking::Observation& value);

}  // namespace suture
