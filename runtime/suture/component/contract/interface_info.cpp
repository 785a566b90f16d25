#include <suture/base/errors.h>
#include <suture/component/contract/interface_info.h>
#include <suture/component/contract/unbounded.h>

#include <algorithm>
#include <string>

namespace suture {

std::uint32_t largestSlot(const InterfaceInfo& info) {
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) {
    largest = std::max({largest, command.argumentsSize, command.resultSize});
  }
  for (const EventInfo& event : info.events) largest = std::max(largest, event.payloadSize);
  return largest;
}

void refuseUnbounded(const InterfaceInfo& info, bool isTask) {
  const std::string why = isTask ? whyUnbounded(info) : "";
  if (why.empty()) return;
  throw SetupError(std::string("a task with the contract ") + info.name, why,
                   "Give it a capacity(), or let a device have this interface");
}

}  // namespace suture
