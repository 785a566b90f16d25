// Written by suturec from 03_own_data_type/display.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "03_own_data_type/display.h"
#include "03_own_data_type/tracker.suture.h"

namespace suture {

template <>
ComponentClass componentClass<tracking::Display>();

}  // namespace suture
