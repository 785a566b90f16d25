#include <suture/base/errors.h>
#include <suture/component/contract/interface_info.h>

#include <algorithm>
#include <string>

namespace suture {
namespace {

/// Returns the name of a command or event that carries an unbounded value; nullptr if there is
/// none.
const char* unboundedPart(const InterfaceInfo& info) {
  for (const CommandInfo& command : info.commands) {
    if (command.sharedArguments || command.sharedResult) return command.name;
  }
  for (const EventInfo& event : info.events) {
    if (event.sharedPayload) return event.name;
  }
  return nullptr;
}

}  // namespace

std::uint32_t largestSlot(const InterfaceInfo& info) {
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) {
    largest = std::max({largest, command.argumentsSize, command.resultSize});
  }
  for (const EventInfo& event : info.events) largest = std::max(largest, event.payloadSize);
  return largest;
}

void refuseUnbounded(const InterfaceInfo& info, bool isTask) {
  const char* const part = isTask ? unboundedPart(info) : nullptr;
  if (part == nullptr) return;
  throw SetupError(std::string("a task with the contract ") + info.name,
                   std::string("'") + part + "' carries what has no bound",
                   "Give it a capacity(), or let a device have this interface");
}

}  // namespace suture
