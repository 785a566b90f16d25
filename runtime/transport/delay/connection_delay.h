#pragma once
// How much longer a connection takes.

#include <suture/base/time.h>

namespace suture {

/// Added to what the lane takes anyway.
struct ConnectionDelay {
  Duration commands{0};  ///< from the client to the provider
  Duration answers{0};  ///< from the provider to the client: answers, events, rows of state, losses

  bool any() const { return commands > Duration{0} || answers > Duration{0}; }
};

}  // namespace suture
