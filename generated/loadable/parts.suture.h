// Written by suturec from loadable/parts.h. Do not edit.
#pragma once

#include <suture/base/slot_forms.h>
#include <suture/component/component_class.h>

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

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, PlatterParameters& value);

}  // namespace loadable

namespace suture {

template <>
ComponentClass componentClass<loadable::Platter>();

template <>
ComponentClass componentClass<loadable::Hand>();

}  // namespace suture
