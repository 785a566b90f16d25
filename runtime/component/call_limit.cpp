#include <suture/component/call_limit.h>
#include <suture/component/channel.h>

#include <algorithm>
#include <cstddef>

namespace suture {

CallLimit callLimitOf(const InterfaceInfo& info) {
  constexpr std::size_t kMostBytes = 4u << 20;
  constexpr unsigned kFewest = 2;
  CallLimit limit{Channel::kMaxCalls, 0};
  for (const CommandInfo& command : info.commands) {
    limit.largestResult = std::max(limit.largestResult, command.resultSize);
  }
  while (limit.calls > kFewest && std::size_t{limit.calls} * limit.largestResult > kMostBytes) {
    limit.calls /= 2;
  }
  return limit;
}

}  // namespace suture
