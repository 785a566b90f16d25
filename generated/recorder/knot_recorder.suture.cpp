// Written by suturec from recorder/knot_recorder.h. Do not edit.
#include "recorder/knot_recorder.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "recorder/knot_recorder.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
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

// --- between slots and Cap'n Proto

void toWire(const KnotRecorderParametersSlot& slot, wire::KnotRecorderParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.file, out.initFile(sizeOf(slot.file)));
}

suture::Errc fromWire(wire::KnotRecorderParameters::Reader in, KnotRecorderParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return in.hasFile() ? fromWire(in.getFile(), slot.file)
      : suture::rpc::fromDefault(KnotRecorderParameters().file, slot.file);
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
Result<std::vector<std::byte>> encode(const robots::KnotRecorderParameters& value) {
  return rpc::encodeAs<robots::wire::KnotRecorderParameters,
                       robots::KnotRecorderParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::KnotRecorderParameters& value) {
  return rpc::decodeAs<robots::wire::KnotRecorderParameters,
                       robots::KnotRecorderParametersSlot>(bytes, value);
}

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
