#pragma once
// By this id processes know that they share a steady clock.

#include <string>

namespace suture {

/// Any thread. Identifies a start of this machine: processes with the same id share the steady
/// clock.
std::string bootId();

}  // namespace suture
