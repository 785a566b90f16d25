// Written by suturec from shapes/bulk.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>

#include "shapes/bulk.h"

namespace shapes {

/// One of each that may be bulk().
struct BulkSlot {
  suture::BoundedList<double, 6> samples;  // m
  std::array<std::int16_t, 3> triple;
  suture::BoundedList<std::uint8_t, 4> bytes;
  suture::BoundedList<float, 5> line;
  std::array<double, 42> jacobian;            // Eigen::Matrix<double, 6, 7>
  suture::BoundedMatrix<double, 3, 4> image;  // Eigen::MatrixXd
};

bool store(const Bulk& value, BulkSlot& slot);
void load(const BulkSlot& slot, Bulk& value);
void reserve(const BulkSlot*, Bulk& value);

bool isValid(const BulkSlot& slot, suture::FieldPath* path);

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Bulk& value);
template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Bulk& value);

}  // namespace suture
