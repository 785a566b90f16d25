#pragma once
// A process that is cut off during a run, and what the slaves make of it.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "run/moment.h"
#include "run/plan.h"

namespace demo {

struct Break {
  std::string process;
  Moment moment;                      ///< of its cut, and how long until it is mended
  std::vector<RecordedSlave> slaves;  ///< that have to hold meanwhile
};

/// A break that has happened.
struct Outage {
  suture::Time broken, mended;
};

/// "vision@4s", or "vision@4s+1500ms" (without a length, one second); none for "". Throws
/// suture::SetupError for any other text, for a system of one process, and as requireRoom() does;
/// suture::DocumentError for a process that the plan does not have.
std::optional<Break> parseBreak(const std::string& text, const Plan& plan,
                                suture::Duration runLength);

}  // namespace demo
