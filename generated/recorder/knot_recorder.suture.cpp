// Written by suturec from recorder/knot_recorder.h. Do not edit.
#include "recorder/knot_recorder.suture.h"

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
static_assert(std::is_same_v<decltype(KnotRecorderParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(KnotRecorderParameters::file), std::string>);

}  // namespace

bool store(const KnotRecorderParameters& value, KnotRecorderParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.file, slot.file);
  return fits;
}

void load(const KnotRecorderParametersSlot& slot, KnotRecorderParameters& value) {
  load(slot.period, value.period);
  load(slot.file, value.file);
}

void reserve(const KnotRecorderParametersSlot*, KnotRecorderParameters& value) {
  suture::reserveFor<decltype(KnotRecorderParametersSlot::file)>(value.file);
}

bool isValid(const KnotRecorderParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, KnotRecorderParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("file", value.file);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::KnotRecorder>() {
  return {"KnotRecorder", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::KnotRecorderParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::KnotRecorder(values));
          }};
}

}  // namespace suture
