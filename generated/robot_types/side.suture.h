// Written by suturec from robot_types/side.h. Do not edit.
#pragma once

#include "robot_types/side.h"

namespace robots {

bool isKnownSide(std::uint8_t slot);

}  // namespace robots
