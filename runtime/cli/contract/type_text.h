#pragma once
// This shows types of a self-description in words.

#include "cli/values/json.h"

#include <string>

namespace suture::cli {

/// Returns "at most 16 of robots::Point".
std::string typeText(const Json& type);
/// Returns the type, unit and range of a field, parameter or result: "Float64 m, 0 to 1".
std::string valueTypeText(const Json& described);

}  // namespace suture::cli
