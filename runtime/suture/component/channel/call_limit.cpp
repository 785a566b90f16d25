#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/memory_budget.h>

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
