#pragma once

#include <exception>
#include <string>

namespace suture {

/// Returns what `attempt` is refused with: the text of what it throws; "" if it throws nothing.
template <class Attempt>
std::string refusal(const Attempt& attempt) {
  try {
    attempt();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace suture
