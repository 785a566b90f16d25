#pragma once
// By what processes know that they share a steady clock.

#include <string>

namespace suture {

/// Identifies a start of this machine: processes with the same share the steady clock. Any thread.
std::string bootId();

}  // namespace suture
