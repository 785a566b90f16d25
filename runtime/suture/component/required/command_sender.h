#pragma once
// A required interface has its commands executed here: by a queue, or in the caller's thread.

#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/required/attachment.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace suture {

/// Belongs to the thread of the component, and needs a connection that is usable.
class CommandSender {
 public:
  explicit CommandSender(Attachment& attachment) : attachment_(attachment) {}

  /// Returns the provider if `command` runs in the caller's thread; else nullptr.
  ProvidedBase* callee(std::uint16_t command) const;

  /// Queues a command whose arguments `fill(std::byte*)` stores; it returns false if they do not
  /// fit. `call` is the number of the call that awaits the answer; 0: none does.
  template <class Fill>
  Errc send(std::uint16_t command, std::uint32_t call, const Fill& fill);
  /// Does the same for a `fill` that is the component's own code: until it returns, other commands
  /// of this interface answer Errc::OnLoan. If it throws, or if the provider cannot be reached by
  /// then, nothing is sent.
  template <class Fill>
  Errc lend(std::uint16_t command, const Fill& fill);
  /// Calls such a `fill()` for a command that runs in this thread, and checks the `arguments` that
  /// it has stored. The command may run if the answer is 0.
  template <class Fill>
  Errc lendHere(std::uint16_t command, const std::byte* arguments, const Fill& fill);
  /// Checks arguments that go to a handler as they are. Answers an error if their slot would not
  /// fit or the contract does not admit them.
  template <class Slot, class... Arguments>
  Errc judgeHere(std::uint16_t command, Arguments&... arguments);
  /// Does the same for the result of a call in this thread.
  template <class Slot, class Value>
  Errc judgeResultHere(std::uint16_t command, const Value& value) const;
  /// Counts a command that ran in this thread: `error` is 0, or Faulted if it threw.
  Errc countHere(Errc error);
  /// Returns how many more of `command` can be sent now. After 0, the component is rung when that
  /// may have changed.
  std::uint32_t room(std::uint16_t command);
  /// Waits at most `limit` until there is room, and returns how much.
  Result<std::uint32_t> roomWithin(std::uint16_t command, Duration limit);
  /// Returns how long within() waits for the answer of `command`.
  Duration deadlineOf(std::uint16_t command) const;

 private:
  const CommandInfo& infoOf(std::uint16_t command) const {
    return attachment_.info().commands[command];
  }
  /// Returns why waiting for room is useless, or 0 if it is not.
  Errc whyNotAwaited(std::uint16_t command) const;
  /// Sets `arguments` to where they go.
  Errc claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments);
  /// Publishes what claim() gave, or gives it up if no provider may see such arguments.
  Errc commit(std::uint16_t command, const std::byte* arguments, bool fits);
  /// Answers an error, and counts it, if the arguments in a slot did not fit or the contract does
  /// not admit them.
  Errc judge(std::uint16_t command, const std::byte* arguments, bool fits);
  /// Returns false for a result that the contract does not admit, and notes that.
  bool admitsResult(std::uint16_t command, const std::byte* result) const;

  /// Keeps other commands away while it lasts, and the memory of the connection, whatever becomes
  /// of that. Gives up what has been claimed, unless it is committed.
  class Loan {
   public:
    Loan(CommandSender& sender, bool claimed)
        : sender_(sender), channel_(sender.attachment_.channel()), claimed_(claimed) {
      sender_.lending_ = true;
    }
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    /// Returns why the connection no longer reaches the provider, or 0 if it does.
    Errc broken(std::uint16_t command) const;
    Errc commit(std::uint16_t command, const std::byte* arguments, bool fits);

   private:
    CommandSender& sender_;
    const std::shared_ptr<Channel> channel_;
    bool claimed_;
  };

  Attachment& attachment_;
  bool lending_ = false;
};

template <class Fill>
Errc CommandSender::send(std::uint16_t command, std::uint32_t call, const Fill& fill) {
  std::byte* arguments = nullptr;
  const Errc error = claim(command, call, arguments);
  return error == Errc{} ? commit(command, arguments, fill(arguments)) : error;
}

template <class Fill>
Errc CommandSender::lend(std::uint16_t command, const Fill& fill) {
  std::byte* arguments = nullptr;
  if (const Errc error = claim(command, 0, arguments); error != Errc{}) return error;
  Loan loan(*this, true);
  return loan.commit(command, arguments, fill(arguments));
}

template <class Fill>
Errc CommandSender::lendHere(std::uint16_t command, const std::byte* arguments, const Fill& fill) {
  if (lending_) return Errc::OnLoan;
  const Loan loan(*this, false);
  const bool fits = fill();
  const Errc error = loan.broken(command);
  return error == Errc{} ? judge(command, arguments, fits) : error;
}

template <class Slot, class... Arguments>
Errc CommandSender::judgeHere(std::uint16_t command, Arguments&... arguments) {
  if (lending_) return Errc::OnLoan;
  if constexpr (sizeof...(Arguments) != 0) {
    if (infoOf(command).accepts == nullptr) return Errc{};
    LooseSlot<Slot> slot;
    const bool fits = store(arguments..., slot.value());
    return judge(command, slot.memory(), fits);
  }
  return Errc{};
}

template <class Slot, class Value>
Errc CommandSender::judgeResultHere(std::uint16_t command, const Value& value) const {
  if (infoOf(command).acceptsResult == nullptr) return Errc{};
  LooseSlot<Slot> slot;
  if (!store(value, slot.value())) return Errc::TooLarge;
  return admitsResult(command, slot.memory()) ? Errc{} : Errc::Invalid;
}

}  // namespace suture
