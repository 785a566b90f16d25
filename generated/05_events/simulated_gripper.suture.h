// Written by suturec from 05_events/simulated_gripper.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "05_events/simulated_gripper.h"
#include "05_events/gripper.suture.h"

namespace suture {

template <>
ComponentClass componentClass<gripping::SimulatedGripper>();

}  // namespace suture
