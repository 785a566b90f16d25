// Written by suturec from loadable/parts.h. Do not edit.
#pragma once

#include <suture/base/encoding.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/factory/component_class.h>

#include "loadable/parts.h"
#include "loadable/turntable.suture.h"

namespace suture {
class JsonReader;
}

namespace loadable {

struct PlatterParametersSlot {
  double angle;
};

bool store(const PlatterParameters& value, PlatterParametersSlot& slot);
void load(const PlatterParametersSlot& slot, PlatterParameters& value);

struct SpindleParametersSlot {
  std::int32_t cycles;
  suture::BoundedText<255> brake;
  suture::BoundedText<255> key;
};

bool store(const SpindleParameters& value, SpindleParametersSlot& slot);
void load(const SpindleParametersSlot& slot, SpindleParameters& value);
void reserve(const SpindleParametersSlot*, SpindleParameters& value);

bool isValid(const PlatterParametersSlot& slot, suture::FieldPath* path);
bool isValid(const SpindleParametersSlot& slot, suture::FieldPath* path);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, PlatterParameters& value);

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SpindleParameters& value);

}  // namespace loadable

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const loadable::PlatterParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, loadable::PlatterParameters& value);

template <>
Result<std::vector<std::byte>> encode(const loadable::SpindleParameters& value);
template <>
Result<> decode(std::span<const std::byte> bytes, loadable::SpindleParameters& value);

template <>
ComponentClass componentClass<loadable::Platter>();

template <>
ComponentClass componentClass<loadable::Hand>();

template <>
ComponentClass componentClass<loadable::Spindle>();

}  // namespace suture
