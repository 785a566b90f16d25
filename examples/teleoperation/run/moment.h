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

/// Throws suture::SetupError, which quotes `asked`, in three cases: the moment begins within the
/// first two seconds, in which the arms get ready; it lasts for less than one second, too short to
/// tell who holds; or it ends less than three before the run does, too late to judge the work.
void requireRoom(const std::string& asked, const Moment& moment, suture::Duration runLength);

}  // namespace demo
