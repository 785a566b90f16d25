#pragma once
// These write numbers in the unit that their column has.

#include <suture/base/time.h>

#include <string>

namespace demo {

/// The text has fewer decimals from 100 ms on, so that a column of ages is as wide as "99.99" up to
/// 100 s.
std::string milliseconds(suture::Duration duration);
std::string microseconds(suture::Duration duration);

}  // namespace demo
