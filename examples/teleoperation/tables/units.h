#pragma once
// Numbers with the unit that their column has.

#include <suture/base/time.h>

#include <string>

namespace demo {

std::string milliseconds(suture::Duration duration);
std::string microseconds(suture::Duration duration);

}  // namespace demo
