// Written by suturec from shapes/bulk.h. Do not edit.
#include "shapes/bulk.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace shapes {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(Bulk::samples), std::vector<double>>);
static_assert(std::is_same_v<decltype(Bulk::triple), std::array<std::int16_t, 3>>);
static_assert(std::is_same_v<decltype(Bulk::bytes), std::vector<std::uint8_t>>);
static_assert(std::is_same_v<decltype(Bulk::line), Eigen::Matrix<float, Eigen::Dynamic, 1>>);
static_assert(std::is_same_v<decltype(Bulk::jacobian), Eigen::Matrix<double, 6, 7>>);
static_assert(std::is_same_v<decltype(Bulk::image), Eigen::MatrixXd>);

}  // namespace

bool store(const Bulk& value, BulkSlot& slot) {
  bool fits = true;
  fits &= store(value.samples, slot.samples);
  fits &= store(value.triple, slot.triple);
  fits &= store(value.bytes, slot.bytes);
  fits &= store(value.line, slot.line);
  fits &= store(value.jacobian, slot.jacobian);
  fits &= store(value.image, slot.image);
  return fits;
}

void load(const BulkSlot& slot, Bulk& value) {
  load(slot.samples, value.samples);
  load(slot.triple, value.triple);
  load(slot.bytes, value.bytes);
  load(slot.line, value.line);
  load(slot.jacobian, value.jacobian);
  load(slot.image, value.image);
}

void reserve(const BulkSlot*, Bulk& value) {
  suture::reserveFor<decltype(BulkSlot::samples)>(value.samples);
  suture::reserveFor<decltype(BulkSlot::bytes)>(value.bytes);
}

bool isValid(const BulkSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.samples, path)) return suture::refusedAt(path, "samples");
  if (!suture::allOf(slot.triple, path, [](const std::int16_t& element) {
    return suture::inRange(element, -5, 5);
  })) {
    return suture::refusedAt(path, "triple");
  }
  if (!isValid(slot.line, path)) return suture::refusedAt(path, "line");
  if (!isValid(slot.jacobian)) return suture::refusedAt(path, "jacobian");
  return isValid(slot.image) || suture::refusedAt(path, "image");
}

}  // namespace shapes
