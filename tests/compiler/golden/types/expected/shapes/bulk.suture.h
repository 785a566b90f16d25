// Written by suturec from shapes/bulk.h. Do not edit.
#pragma once

#include <suture/base/slots.h>

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

inline bool store(const Bulk& value, BulkSlot& slot) {
  using suture::store;
  bool fits = true;
  fits &= store(value.samples, slot.samples);
  fits &= store(value.triple, slot.triple);
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.line, slot.line);
  fits &= store(value.jacobian, slot.jacobian);
  fits &= store(value.image, slot.image);
  return fits;
}

inline void load(const BulkSlot& slot, Bulk& value) {
  using suture::load;
  load(slot.samples, value.samples);
  load(slot.triple, value.triple);
  load(slot.bytes, value.bytes);
  load(slot.line, value.line);
  load(slot.jacobian, value.jacobian);
  load(slot.image, value.image);
}

}  // namespace shapes
