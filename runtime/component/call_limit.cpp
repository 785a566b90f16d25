#include <suture/component/call_limit.h>
#include <suture/component/channel.h>
#include <suture/component/memory_budget.h>

#include <algorithm>
#include <cstddef>

namespace suture {

CallLimit callLimitOf(const InterfaceInfo& info) {
  CallLimit limit{};
  for (const CommandInfo& command : info.commands) {
    limit.largestResult = std::max(limit.largestResult, command.resultSize);
  }
  limit.calls = fewerOfLarge(Channel::kMaxCalls, 2, [&](unsigned calls) {
    return std::size_t{calls} * limit.largestResult;
  });
  return limit;
}

}  // namespace suture
