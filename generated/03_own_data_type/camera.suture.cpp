// Written by suturec from 03_own_data_type/camera.h. Do not edit.
#include "03_own_data_type/camera.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "03_own_data_type/camera.capnp.h"

// Defined in 03_own_data_type/observation.suture.cpp.
namespace tracking {
void toWire(const ObservationSlot& slot, wire::Observation::Builder out);
suture::Errc fromWire(wire::Observation::Reader in, ObservationSlot& slot, suture::Duration shift);
bool isValid(const ObservationSlot& slot, suture::FieldPath* path);
}  // namespace tracking

namespace tracking {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(CameraParameters::first), Observation>);
static_assert(std::is_same_v<decltype(CameraParameters::turn_rate), double>);

}  // namespace

bool store(const CameraParameters& value, CameraParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.first, slot.first);
  fits &= store(value.turn_rate, slot.turn_rate);
  return fits;
}

void load(const CameraParametersSlot& slot, CameraParameters& value) {
  load(slot.first, value.first);
  load(slot.turn_rate, value.turn_rate);
}

void reserve(const CameraParametersSlot*, CameraParameters& value) {
  suture::reserveFor<decltype(CameraParametersSlot::first)>(value.first);
}

// --- between slots and Cap'n Proto

void toWire(const CameraParametersSlot& slot, wire::CameraParameters::Builder out) {
  toWire(slot.first, out.initFirst());
  out.setTurnRate(slot.turn_rate);
}

suture::Errc fromWire(wire::CameraParameters::Reader in, CameraParametersSlot& slot,
                      suture::Duration shift) {
  slot.turn_rate = in.getTurnRate();
  return fromWire(in.getFirst(), slot.first, shift);
}

bool isValid(const CameraParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.first, path)) return suture::refusedAt(path, "first");
  return suture::rpc::inRange(slot.turn_rate, -10, 10) || suture::refusedAt(path, "turn_rate");
}

}  // namespace tracking

// Defined in 03_own_data_type/observation.suture.cpp.
namespace tracking {
void fromJson(const suture::JsonReader& in, Observation& value);
}  // namespace tracking

namespace tracking {

void fromJson(const suture::JsonReader& in, CameraParameters& value) {
  suture::JsonReader reader = in;
  reader.field("first", value.first);
  reader.field("turn_rate", value.turn_rate, -10, 10);
  reader.finish();
}

}  // namespace tracking

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const tracking::CameraParameters& value) {
  return rpc::encodeAs<tracking::wire::CameraParameters, tracking::CameraParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, tracking::CameraParameters& value) {
  return rpc::decodeAs<tracking::wire::CameraParameters,
                       tracking::CameraParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<tracking::Camera>() {
  return {"Camera", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            tracking::CameraParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new tracking::Camera(values));
          }};
}

}  // namespace suture
