#pragma once
// This makes texts that other processes wrote fit to be shown.

#include <string>

namespace suture {

/// Returns `text` without control codes, with which the text of a peer could steer a terminal.
std::string plain(const std::string& text);

}  // namespace suture
