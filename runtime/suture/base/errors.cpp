#include <suture/base/errors.h>

namespace suture {

const char* toString(Errc error) {
  if (error == Errc{}) return "no error";
  switch (error) {
    case Errc::NotConnected: return "not connected";
    case Errc::Lost: return "connection lost";
    case Errc::Full: return "the provider's queue for this command is full";
    case Errc::TooLarge: return "larger than the declared capacity";
    case Errc::NotYet: return "not produced yet";
    case Errc::Timeout: return "deadline passed";
    case Errc::OutcomeUnknown: return "connection lost after sending; outcome unknown";
    case Errc::Late: return "older than its ttl";
    case Errc::Superseded: return "a later command had already run";
    case Errc::Faulted: return "the provider's handler threw";
    case Errc::Invalid: return "value outside its declared limits";
    case Errc::TooManyCalls: return "too many unfinished calls";
    case Errc::WrongThread: return "called from another thread than the component's own";
    case Errc::NotImplemented: return "the provider does not have this command";
    case Errc::TooOld: return "older than the state table's oldest row";
    case Errc::Suspended: return "the provider is suspended";
    case Errc::Stale: return "older than the connection's max_age";
    case Errc::AwaitingOperator: return "the connection waits for an operator to resume it";
    case Errc::Cancelled: return "cancelled before it was executed";
    case Errc::CannotWait: return "an event cannot be awaited here, or has a direct handler";
    case Errc::NotPermitted: return "the provider's policy lets this process read, not command";
    case Errc::OnLoan: return "a loan of this interface is being filled";
  }
  return "unknown error";
}

SetupError::SetupError(std::string_view asked, std::string_view found, std::string_view remedy)
    : std::runtime_error(std::string(asked) + ": " + std::string(found) + ". " +
                         std::string(remedy)) {}

}  // namespace suture
