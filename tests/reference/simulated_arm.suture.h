// Written by suturec from reference/simulated_arm.h. Do not edit.
#pragma once

#include <suture/component/component_class.h>

#include "reference/simulated_arm.h"
#include "reference/arm_like.suture.h"

namespace suture {
class JsonReader;
}

namespace reference {

/// Reads what `in` says into `value`; what it does not mention keeps its default.
void fromJson(const suture::JsonReader& in, SimulatedArmParameters& value);

}  // namespace reference

namespace suture {

template <>
ComponentClass componentClass<reference::SimulatedArm>();

}  // namespace suture
