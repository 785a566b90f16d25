// Written by suturec from 03_own_data_type/camera.h. Do not edit.
#include "03_own_data_type/camera.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace tracking {

using suture::isValid;
using suture::load;
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

bool isValid(const CameraParametersSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.first, path)) return suture::refusedAt(path, "first");
  return suture::inRange(slot.turn_rate, -10, 10) || suture::refusedAt(path, "turn_rate");
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
ComponentClass componentClass<tracking::Camera>() {
  return {"Camera", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            tracking::CameraParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new tracking::Camera(values));
          }};
}

}  // namespace suture
