#pragma once
// How things fail. At run time: an Errc inside a Result or a Sample, without allocation. While a
// system is being put together: a SetupError that says what was asked, what was found and what to
// do.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <type_traits>

namespace suture {

/// Why a call or a read has no value.
enum class Errc : std::uint8_t {
  NotConnected = 1,  ///< the required interface was never connected
  Lost,              ///< the connection broke; nothing reaches the provider until it is back
  Full,              ///< the provider still has as many of this command waiting as it accepts
  TooLarge,          ///< a string or list exceeds the capacity its header declares, or all of it
                     ///< what a link carries in one message
  NotYet,            ///< nobody has produced this value so far; asking started its production
  Timeout,           ///< the deadline passed; whether the provider ran the call is not known
  OutcomeUnknown,    ///< the connection broke after the call was sent; it may have run
  Late,              ///< older than the command's ttl when its turn came; not executed
  Superseded,        ///< a later command of the same connection had run already; not executed
  Faulted,           ///< the provider's handler threw; its component is parked
  Invalid,           ///< a value is outside what its header allows
  TooManyCalls,      ///< this required interface has as many unfinished calls as it can follow
  WrongThread,       ///< calls and events belong to the component's thread, and this is another
  NotImplemented,    ///< a command that this provider does not have: optional, or newer than it
  TooOld,            ///< the state table does not reach back that far; configure more rows
  Suspended,         ///< the provider is suspended; the command was not executed
  Stale,             ///< older than the connection's max_age
  AwaitingOperator,  ///< after a loss, until somebody resumes it; nothing was sent
  Cancelled,         ///< its sender cancelled it in time; not executed
  CannotWait,        ///< an event is not awaited in an event's handler, nor if its own is direct
  NotPermitted,      ///< the provider's policy lets this process read, not command; not executed
};

/// The error in words, for people. Any thread; static storage.
const char* toString(Errc error);

/// What a command answers. Success of a queued command means that it waits at the provider.
template <class T = void>
using Result = tl::expected<T, Errc>;

/// What a command without a value answers. `Nothing` is void: as this is a template, Result<void>
/// is compiled only for those who use it, not for all who include this.
template <class Nothing>
Result<Nothing> resultOf(Errc error) {
  static_assert(std::is_void_v<Nothing>);
  return error == Errc{} ? Result<Nothing>{} : Result<Nothing>{tl::unexpect, error};
}

/// Thrown while a system is put together (never from a control loop).
class SetupError : public std::runtime_error {
 public:
  /// `asked`: what was wanted, `found`: what was there instead, `remedy`: what to do about it.
  SetupError(std::string_view asked, std::string_view found, std::string_view remedy);
  /// `text` has all three parts already: another process wrote it.
  explicit SetupError(const std::string& text) : runtime_error(text) {}
};

}  // namespace suture
