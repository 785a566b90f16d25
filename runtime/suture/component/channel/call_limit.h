#pragma once

#include <suture/component/contract/interface_info.h>

#include <cstdint>

namespace suture {

/// Limits the calls for which a connection has memory, at both of its ends.
struct CallLimit {
  unsigned calls;  ///< calls with an answer, unfinished at a time; at most Channel::kMaxCalls
  std::uint32_t largestResult;  ///< bytes of a slot
};

/// Any thread. Returns the limits: fewer calls where results are large (memory_budget.h).
CallLimit callLimitOf(const InterfaceInfo& info);

}  // namespace suture
