#pragma once
// This is a trial in real time: two processes in two network namespaces, and the kernel's TCP
// between them.

#include <suture/rt/scheduling.h>

#include <cstdint>

#include "experiment/result.h"
#include "experiment/trial.h"

namespace experiment {

struct RealTimeResult {
  Result result;
  std::uint64_t packets = 0, lost = 0;  ///< sums over both directions
};

/// Call it in a process with one thread, that may make namespaces with TUN devices: it throws
/// suture::SetupError in another, and std::runtime_error if a side fails. It takes kLength and some
/// seconds. `scheduling` is that of all threads of both sides.
RealTimeResult runInRealTime(const Trial& trial, const suture::rt::Scheduling& scheduling);

}  // namespace experiment
