// Written by suturec from shapes/bulk.h. Do not edit.
#include "shapes/bulk.suture.h"

#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "shapes/bulk.capnp.h"

namespace shapes {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const BulkSlot& slot, wire::Bulk::Builder out) {
  toWire(slot.samples, out.initSamples(sizeOf(slot.samples) * sizeof(double)));
  toWire(slot.triple, out.initTriple(3 * sizeof(std::int16_t)));
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  toWire(slot.line, out.initLine(sizeOf(slot.line) * sizeof(float)));
  toWire(slot.jacobian, out.initJacobian(42 * sizeof(double)));
  toWire(slot.image, out.initImage());
}

suture::Errc fromWire(wire::Bulk::Reader in, BulkSlot& slot, suture::Duration) {
  return suture::rpc::firstError({
      fromWire(in.getSamples(), slot.samples),
      fromWire(in.getTriple(), slot.triple),
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getLine(), slot.line),
      in.getJacobian().size() != 0 ? fromWire(in.getJacobian(), slot.jacobian)
          : suture::rpc::fromDefault(Bulk().jacobian, slot.jacobian),
      fromWire(in.getImage(), slot.image),
  });
}

bool isValid(const BulkSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.samples, path)) return suture::refusedAt(path, "samples");
  if (!suture::rpc::allOf(slot.triple, path, [](const std::int16_t& element) {
    return suture::rpc::inRange(element, -5, 5);
  })) {
    return suture::refusedAt(path, "triple");
  }
  if (!isValid(slot.line, path)) return suture::refusedAt(path, "line");
  if (!isValid(slot.jacobian)) return suture::refusedAt(path, "jacobian");
  return isValid(slot.image) || suture::refusedAt(path, "image");
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Bulk& value) {
  return rpc::encodeAs<shapes::wire::Bulk, shapes::BulkSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Bulk& value) {
  return rpc::decodeAs<shapes::wire::Bulk, shapes::BulkSlot>(bytes, value);
}

}  // namespace suture
