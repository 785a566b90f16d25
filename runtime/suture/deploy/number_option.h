#pragma once
// These are numbers and times that are typed on a command line. What is not finite, or lies outside
// its limits, is refused there: it would mean another time, or none.

#include <suture/base/time.h>

#include <string>

namespace suture {

/// Returns which number to give, if `text` is none from `least` to `most`; else "".
std::string whyNotNumber(const std::string& text, double least, double most);

/// Returns which time to give, if `text` is none that a program can wait for, in seconds; else "".
std::string whyNotTime(const std::string& text);

/// Returns a time that one of these has let through; it is at most 1e9 s.
Duration fromSeconds(double seconds);

}  // namespace suture
