// Written by suturec from 04_contract_and_loss/follower.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "04_contract_and_loss/follower.h"
#include "04_contract_and_loss/joystick.suture.h"

namespace suture {

template <>
ComponentClass componentClass<following::Follower>();

}  // namespace suture
