// Written by suturec from recorder/recorder.h. Do not edit.
#include "recorder/recorder.suture.h"

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
static_assert(std::is_same_v<decltype(RecorderParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(RecorderParameters::file), std::string>);

}  // namespace

bool store(const RecorderParameters& value, RecorderParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.file, slot.file);
  return fits;
}

void load(const RecorderParametersSlot& slot, RecorderParameters& value) {
  load(slot.period, value.period);
  load(slot.file, value.file);
}

void reserve(const RecorderParametersSlot*, RecorderParameters& value) {
  suture::reserveFor<decltype(RecorderParametersSlot::file)>(value.file);
}

bool isValid(const RecorderParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, RecorderParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("file", value.file);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::Recorder>() {
  return {"Recorder", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::RecorderParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::Recorder(values));
            makeOptional(*component, {"Teleoperation", "Stop"});
            return component;
          }};
}

}  // namespace suture
