#pragma once
// This says how things fail. At run time, an Errc in a Result or a Sample tells why, without
// allocation. While a system is put together, a SetupError says what was asked, what was found and
// what to do.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <type_traits>

namespace suture {

/// Tells why a call or a read has no value.
enum class Errc : std::uint8_t {
  NotConnected = 1,  ///< the required interface has no connection at this moment
  Lost,              ///< the connection broke; nothing reaches the provider until it is back
  Full,              ///< as many of this command wait at the provider as it accepts
  TooLarge,          ///< a string or list exceeds the capacity that its header declares, or the
                     ///< value exceeds what a link carries in one message
  NotYet,            ///< the provider has not produced this value yet; this read made it start
  Timeout,           ///< the deadline passed; the provider may have run the call or not
  OutcomeUnknown,    ///< the connection broke after the call was sent; it may have run
  Late,              ///< the command was older than its ttl when its turn came; not executed
  Superseded,        ///< a later command of the same connection had run already; not executed
  Faulted,           ///< the provider's component is faulted: its code threw, or a policy said so
  Invalid,           ///< a value is outside what its header allows
  TooManyCalls,      ///< this required interface has as many unfinished calls as it can follow
  WrongThread,       ///< calls and events belong to the component's thread, and this is another
  NotImplemented,    ///< a command that this provider does not have: optional, or newer than it
  TooOld,            ///< the state table does not reach back that far; configure more rows
  Suspended,         ///< the provider is suspended; the command was not executed
  Stale,             ///< the value is older than the connection's max_age
  AwaitingOperator,  ///< a loss, a fault or a stale read came, and an operator has not resumed the
                     ///< connection since; nothing was sent
  Cancelled,         ///< the sender cancelled the command in time; it was not executed
  CannotWait,        ///< events cannot be awaited in an event's handler, nor can those whose own
                     ///< handler is direct
  NotPermitted,      ///< the provider's policy lets this process read but not command; not executed
  OnLoan,            ///< this required interface is filling a loan; nothing was sent
};

/// No error has a larger number.
inline constexpr Errc kLastErrc = Errc::OnLoan;

/// Any thread. Returns the error that another process tells by its number; 0 stands for none. A
/// newer process may have errors that this build does not know: then the call may have run.
constexpr Errc toldErrc(unsigned number) {
  return number <= static_cast<unsigned>(kLastErrc) ? static_cast<Errc>(number)
                                                    : Errc::OutcomeUnknown;
}

/// Any thread. Returns the error in words, for people, in static storage.
const char* toString(Errc error);

/// Holds what a command answers. Success of a queued command means that it waits at the provider.
template <class T = void>
using Result = tl::expected<T, Errc>;

/// Any thread. Returns what a command without a value answers. `Nothing` is always void: a template
/// costs the files that include this header nothing unless they use it.
template <class Nothing>
Result<Nothing> resultOf(Errc error) {
  static_assert(std::is_void_v<Nothing>);
  return error == Errc{} ? Result<Nothing>{} : Result<Nothing>{tl::unexpect, error};
}

/// The set-up code throws this while a system is put together, and never in a control loop.
class SetupError : public std::runtime_error {
 public:
  /// `asked` says what was wanted, `found` what was there instead, `remedy` what to do about it.
  SetupError(std::string_view asked, std::string_view found, std::string_view remedy);
  /// `text` has all three parts already, because another process wrote it.
  explicit SetupError(const std::string& text) : runtime_error(text) {}
};

}  // namespace suture
