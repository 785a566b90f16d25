#pragma once
// These write numbers in the unit that their column has, and with what they count.

#include <suture/base/time.h>

#include <cstddef>
#include <string>

namespace demo {

/// The text has fewer decimals from 100 ms on, so that a column of ages is as wide as "99.99" up to
/// 100 s.
std::string milliseconds(suture::Duration duration);
std::string microseconds(suture::Duration duration);

/// Returns the number with its noun: "1 process", "2 processes", "3 connections".
std::string counted(std::size_t number, const std::string& noun);

}  // namespace demo
