// Written by suturec from 03_own_data_type/observation.h. Do not edit.
#include "03_own_data_type/observation.suture.h"

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
static_assert(std::is_same_v<std::underlying_type_t<Visibility>, std::uint8_t>);
static_assert(static_cast<std::uint8_t>(Visibility::Hidden) == 0);
static_assert(static_cast<std::uint8_t>(Visibility::Partial) == 1);
static_assert(static_cast<std::uint8_t>(Visibility::Full) == 2);
static_assert(std::is_same_v<decltype(Marker::number), std::uint32_t>);
static_assert(std::is_same_v<decltype(Marker::position), Eigen::Vector3d>);
static_assert(std::is_same_v<decltype(Observation::instrument), std::string>);
static_assert(std::is_same_v<decltype(Observation::visibility), Visibility>);
static_assert(std::is_same_v<decltype(Observation::tip), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(Observation::markers), std::vector<tracking::Marker>>);
static_assert(std::is_same_v<decltype(Observation::jaw_angle), double>);

}  // namespace

bool store(const Marker& value, MarkerSlot& slot) {
  bool fits = true;
  fits &= store(value.number, slot.number);
  fits &= store(value.position, slot.position);
  return fits;
}

void load(const MarkerSlot& slot, Marker& value) {
  load(slot.number, value.number);
  load(slot.position, value.position);
}

bool store(const Observation& value, ObservationSlot& slot) {
  bool fits = true;
  fits &= store(value.instrument, slot.instrument);
  fits &= store(value.visibility, slot.visibility);
  fits &= store(value.tip, slot.tip);
  fits &= store(value.markers, slot.markers);
  fits &= store(value.jaw_angle, slot.jaw_angle);
  return fits;
}

void load(const ObservationSlot& slot, Observation& value) {
  load(slot.instrument, value.instrument);
  load(slot.visibility, value.visibility);
  load(slot.tip, value.tip);
  load(slot.markers, value.markers);
  load(slot.jaw_angle, value.jaw_angle);
}

void reserve(const ObservationSlot*, Observation& value) {
  suture::reserveFor<decltype(ObservationSlot::instrument)>(value.instrument);
  suture::reserveFor<decltype(ObservationSlot::markers)>(value.markers);
}

bool isKnownVisibility(std::uint8_t slot) {
  switch (static_cast<Visibility>(slot)) {
    case Visibility::Hidden:
    case Visibility::Partial:
    case Visibility::Full:
      return true;
  }
  return false;
}

bool isValid(const MarkerSlot& slot, suture::FieldPath* path) {
  return isValid(slot.position, path) || suture::refusedAt(path, "position");
}

bool isValid(const ObservationSlot& slot, suture::FieldPath* path) {
  if (!isKnownVisibility(slot.visibility)) return suture::refusedAt(path, "visibility");
  if (!isValid(slot.tip)) return suture::refusedAt(path, "tip");
  if (!suture::allOf(slot.markers, path, [path](const MarkerSlot& element) {
    return isValid(element, path);
  })) {
    return suture::refusedAt(path, "markers");
  }
  return suture::inRange(slot.jaw_angle, 0, 1.6) || suture::refusedAt(path, "jaw_angle");
}

}  // namespace tracking

namespace tracking {

inline void fromJson(const suture::JsonReader& in, Visibility& value) {
  static constexpr Visibility kValues[] = {Visibility::Hidden, Visibility::Partial,
                                           Visibility::Full};
  const int index = suture::enumeratorFromJson(in, {"Hidden", "Partial", "Full"});
  if (index >= 0) value = kValues[index];
}

inline void fromJson(const suture::JsonReader& in, Marker& value) {
  suture::JsonReader reader = in;
  reader.field("number", value.number);
  reader.field("position", value.position);
  reader.finish();
}

void fromJson(const suture::JsonReader& in, Observation& value) {
  suture::JsonReader reader = in;
  reader.field("instrument", value.instrument);
  reader.field("visibility", value.visibility);
  reader.field("tip", value.tip);
  reader.field("markers", value.markers);
  reader.field("jaw_angle", value.jaw_angle, 0, 1.6);
  reader.finish();
}

}  // namespace tracking
