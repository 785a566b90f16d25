#pragma once

#include <suture/component/interface_info.h>

#include <cstdint>

namespace suture {

/// What a connection keeps memory for, at both of its ends.
struct CallLimit {
  unsigned calls;  ///< with an answer, unfinished at a time; at most Channel::kMaxCalls
  std::uint32_t largestResult;  ///< bytes, of a slot
};

/// Of large results fewer are kept (memory_budget.h). Any thread.
CallLimit callLimitOf(const InterfaceInfo& info);

}  // namespace suture
