#pragma once
// This says when something is done to a running system, and for how long.

#include <suture/base/time.h>

#include <optional>
#include <string>

namespace demo {

struct Moment {
  suture::Duration at{};  ///< from when the system runs on
  suture::Duration length = std::chrono::seconds(1);
};

/// Parses "4s", or "4s+1500ms"; none for any other text.
std::optional<Moment> parseMoment(const std::string& text);

/// Throws suture::SetupError, with `asked` as what was asked, if the moment begins within two
/// seconds, while the arms get ready, lasts for less than one, in which it could not be told who
/// holds, or ends less than three before the run does, so that it can be judged.
void requireRoom(const std::string& asked, const Moment& moment, suture::Duration runLength);

}  // namespace demo
