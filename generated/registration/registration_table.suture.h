// Written by suturec from registration/registration_table.h. Do not edit.
#pragma once

#include <suture/component/factory/component_class.h>

#include "registration/registration_table.h"
#include "registration/registration.suture.h"

namespace suture {

template <>
ComponentClass componentClass<robots::RegistrationTable>();

}  // namespace suture
