#include <suture/component/contract/interface_info.h>

#include <algorithm>

namespace suture {

std::uint32_t largestSlot(const InterfaceInfo& info) {
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) {
    largest = std::max({largest, command.argumentsSize, command.resultSize});
  }
  for (const EventInfo& event : info.events) largest = std::max(largest, event.payloadSize);
  return largest;
}

}  // namespace suture
