// Written by suturec from robot_types/side.h. Do not edit.
#pragma once


#include "robot_types/side.h"
