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

}  // namespace suture
