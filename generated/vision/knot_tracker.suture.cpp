// Written by suturec from vision/knot_tracker.h. Do not edit.
#include "vision/knot_tracker.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(TrackerParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TrackerParameters::max_age), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(TrackerParameters::acceleration), double>);

}  // namespace

bool store(const TrackerParameters& value, TrackerParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.max_age, slot.max_age);
  fits &= store(value.acceleration, slot.acceleration);
  return fits;
}

void load(const TrackerParametersSlot& slot, TrackerParameters& value) {
  load(slot.period, value.period);
  load(slot.max_age, value.max_age);
  load(slot.acceleration, value.acceleration);
}

bool isValid(const TrackerParametersSlot& slot, suture::FieldPath* path) {
  return suture::inRange(slot.acceleration, 0.001, 100) || suture::refusedAt(path, "acceleration");
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, TrackerParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("max_age", value.max_age);
  reader.field("acceleration", value.acceleration, 0.001, 100);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::KnotTracker>() {
  return {"KnotTracker", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::TrackerParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::KnotTracker(values));
          }};
}

}  // namespace suture
