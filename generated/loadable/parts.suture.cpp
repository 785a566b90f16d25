// Written by suturec from loadable/parts.h. Do not edit.
#include "loadable/parts.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace loadable {

using suture::isValid;
using suture::load;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(PlatterParameters::angle), double>);
static_assert(std::is_same_v<decltype(SpindleParameters::cycles), std::int32_t>);
static_assert(std::is_same_v<decltype(SpindleParameters::brake), std::string>);
static_assert(std::is_same_v<decltype(SpindleParameters::key), std::string>);

}  // namespace

bool store(const PlatterParameters& value, PlatterParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.angle, slot.angle);
  return fits;
}

void load(const PlatterParametersSlot& slot, PlatterParameters& value) {
  load(slot.angle, value.angle);
}

bool store(const SpindleParameters& value, SpindleParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.cycles, slot.cycles);
  fits &= store(value.brake, slot.brake);
  fits &= store(value.key, slot.key);
  return fits;
}

void load(const SpindleParametersSlot& slot, SpindleParameters& value) {
  load(slot.cycles, value.cycles);
  load(slot.brake, value.brake);
  load(slot.key, value.key);
}

void reserve(const SpindleParametersSlot*, SpindleParameters& value) {
  suture::reserveFor<decltype(SpindleParametersSlot::brake)>(value.brake);
  suture::reserveFor<decltype(SpindleParametersSlot::key)>(value.key);
}

bool isValid(const PlatterParametersSlot& slot, suture::FieldPath* path) {
  return isValid(slot.angle) || suture::refusedAt(path, "angle");
}

bool isValid(const SpindleParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace loadable

namespace loadable {

void fromJson(const suture::JsonReader& in, PlatterParameters& value) {
  suture::JsonReader reader = in;
  reader.field("angle", value.angle);
  reader.finish();
}

void fromJson(const suture::JsonReader& in, SpindleParameters& value) {
  suture::JsonReader reader = in;
  reader.field("cycles", value.cycles);
  reader.field("brake", value.brake);
  reader.field("key", value.key);
  reader.finish();
}

}  // namespace loadable

namespace suture {

template <>
ComponentClass componentClass<loadable::Platter>() {
  return {"Platter", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            loadable::PlatterParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new loadable::Platter(values));
          }};
}

template <>
ComponentClass componentClass<loadable::Hand>() {
  return {"Hand", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new loadable::Hand());
            makeOptional(*component, {"Other"});
            return component;
          }};
}

template <>
ComponentClass componentClass<loadable::Spindle>() {
  return {"Spindle", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            loadable::SpindleParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new loadable::Spindle(values));
          }};
}

}  // namespace suture
