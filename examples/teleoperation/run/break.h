#pragma once
// This cuts off a process during a run, and says which slaves have to hold.

#include <suture/base/time.h>

#include <optional>
#include <string>
#include <vector>

#include "run/moment.h"
#include "run/network.h"
#include "run/plan.h"

namespace demo {

struct Break {
  std::string process;
  Moment moment;                      ///< when it is cut off, and how long until it is back
  std::vector<RecordedSlave> slaves;  ///< the slaves that have to hold meanwhile
};

/// An Outage is a break that has happened.
struct Outage {
  suture::Time broken, mended;
};

/// Parses "vision@4s", or "vision@4s+1500ms" (without a length it is one second); none for "".
/// Throws suture::SetupError for any other text, for a system of one process, and as requireRoom()
/// does; suture::DocumentError for a process that the plan does not have.
std::optional<Break> parseBreak(const std::string& text, const Plan& plan, const Network& network,
                                suture::Duration runLength);

}  // namespace demo
