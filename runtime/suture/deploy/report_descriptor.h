#pragma once
// This is the descriptor for reports, as it is typed. It is checked before the process opens
// anything, because a number that is free then is that of a socket or a recording later.

#include <optional>
#include <string>

namespace suture {

/// Returns the descriptor that `text` means, standard output for "-"; none if it is no number.
std::optional<int> descriptorIn(const std::string& text);

/// Returns why nothing can be written to the descriptor that `text` means, and what to do; "" if
/// something can.
std::string whyNotWritable(const std::string& text);

}  // namespace suture
