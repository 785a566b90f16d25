#pragma once
// Texts that others wrote, made fit to be shown.

#include <string>

namespace suture {

/// Without what would steer a terminal: texts of peers may be anything.
std::string plain(const std::string& text);

}  // namespace suture
