// Written by suturec from 01_counter/clicker.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "01_counter/clicker.h"
#include "01_counter/counter.suture.h"

namespace suture {

template <>
ComponentClass componentClass<counting::Clicker>();

}  // namespace suture
