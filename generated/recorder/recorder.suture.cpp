// Written by suturec from recorder/recorder.h. Do not edit.
#include "recorder/recorder.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "recorder/recorder.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const RecorderParametersSlot& slot, wire::RecorderParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
}

suture::Errc fromWire(wire::RecorderParameters::Reader in, RecorderParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return in.hasFile() ? fromWire(in.getFile(), slot.file)
      : suture::rpc::fromDefault(RecorderParameters().file, slot.file);
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
Result<std::vector<std::byte>> encode(const robots::RecorderParameters& value) {
  return rpc::encodeAs<robots::wire::RecorderParameters, robots::RecorderParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::RecorderParameters& value) {
  return rpc::decodeAs<robots::wire::RecorderParameters,
                       robots::RecorderParametersSlot>(bytes, value);
}

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
