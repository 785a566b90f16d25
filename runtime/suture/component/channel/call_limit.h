#pragma once

#include <suture/component/contract/interface_info.h>

#include <cstdint>

namespace suture {

/// What a connection keeps memory for, at both of its ends.
struct CallLimit {
  unsigned calls;  ///< with an answer, unfinished at a time; at most Channel::kMaxCalls
  std::uint32_t largestResult;  ///< bytes, of a slot
};

/// Any thread. Fewer calls are kept where results are large (memory_budget.h).
CallLimit callLimitOf(const InterfaceInfo& info);

}  // namespace suture
