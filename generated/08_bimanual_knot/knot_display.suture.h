// Written by suturec from 08_bimanual_knot/knot_display.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "08_bimanual_knot/knot_display.h"
#include "guidance/guidance.suture.h"

namespace suture {

template <>
ComponentClass componentClass<watching::KnotDisplay>();

}  // namespace suture
