// Written by suturec from 01_counter/tally.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "01_counter/tally.h"
#include "01_counter/counter.suture.h"

namespace suture {

template <>
ComponentClass componentClass<counting::Tally>();

}  // namespace suture
