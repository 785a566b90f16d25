#pragma once
// This is the contract of a component that tracks an instrument. The read returns a reference,
// because a value that owns memory would be allocated in each cycle of the provider; suturec
// insists on it.

#include <suture/annotate.h>

#include "03_own_data_type/observation.suture.h"

namespace tracking {

class SUTURE_INTERFACE() Tracker {
 public:
  virtual ~Tracker() = default;

  /// Returns the newest observation; never waits for anyone.
  SUTURE_COMMAND() virtual const Observation& observation() const = 0;
};

}  // namespace tracking
