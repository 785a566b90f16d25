#include <suture/base/errors.h>
#include <suture/component/contract/unbounded.h>

namespace suture {

std::string whyUnbounded(const InterfaceInfo& info) {
  for (const CommandInfo& one : info.commands) {
    if (one.sharedArguments || one.sharedResult) {
      return std::string("command '") + one.name + "' has values without a bound";
    }
  }
  for (const EventInfo& one : info.events) {
    if (one.sharedPayload)
      return std::string("event '") + one.name + "' has a payload without a bound";
  }
  return "";
}

void refuseUnbounded(const InterfaceInfo& info, bool isTask) {
  const std::string why = isTask ? whyUnbounded(info) : "";
  if (why.empty()) return;
  throw SetupError(std::string("a task with the contract ") + info.name, why,
                   "Give it a capacity(), or let a device have this interface");
}

}  // namespace suture
