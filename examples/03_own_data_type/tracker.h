#pragma once
// The contract: whoever tracks an instrument tells what it sees. The read answers a reference,
// since a value that owns memory would be allocated in each cycle of the provider; suturec insists
// on it.

#include <suture/annotate.h>

#include "03_own_data_type/observation.suture.h"

namespace tracking {

class SUTURE_INTERFACE() Tracker {
 public:
  virtual ~Tracker() = default;

  /// The newest observation; never waits for anyone.
  SUTURE_COMMAND() virtual const Observation& observation() const = 0;
};

}  // namespace tracking
