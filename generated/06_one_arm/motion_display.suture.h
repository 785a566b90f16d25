// Written by suturec from 06_one_arm/motion_display.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "06_one_arm/motion_display.h"
#include "arm/arm.suture.h"
#include "teleop/teleoperation.suture.h"

namespace suture {

template <>
ComponentClass componentClass<watching::MotionDisplay>();

}  // namespace suture
