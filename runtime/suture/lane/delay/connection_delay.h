#pragma once
// This says how much longer a connection takes, and which faults its messages meet.

#include <suture/base/time.h>
#include <suture/lane/fault/fault_plan.h>

namespace suture {

/// These times are added to what the lane takes anyway.
struct ConnectionDelay {
  Duration commands{0};  ///< from the client to the provider
  Duration answers{0};  ///< from the provider to the client: answers, events, rows of state, losses
  FaultPlan faults{};   ///< tests say here what befalls each message, both ways

  bool any() const { return commands > Duration{0} || answers > Duration{0} || faults.any(); }
};

}  // namespace suture
