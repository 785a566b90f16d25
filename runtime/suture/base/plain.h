#pragma once
// Makes texts that others wrote fit to be shown.

#include <string>

namespace suture {

/// Returns `text` without what would steer a terminal, since texts of peers may be anything.
std::string plain(const std::string& text);

}  // namespace suture
