#pragma once
// These are the members of a generated Required<Contract>: one object for each command. All belong
// to the thread of the component that owns the required interface.

#include <suture/base/sample.h>
#include <suture/base/slots/loan.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/component/call.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <tuple>
#include <type_traits>
#include <utility>

namespace suture {

/// Runs `body(Contract&)` on `callee`, in this thread. If it throws, that parks the provider's
/// component and not the caller.
template <class Contract, class Body>
Errc runHere(ProvidedBase& callee, const Body& body) {
  const bool returned = callee.owner().parkSoonOnThrow([&] {
    const InterfaceInfo& contract = interfaceInfo<std::remove_const_t<Contract>>();
    body(*static_cast<Contract*>(callee.implementation(contract)));
  });
  return returned ? Errc{} : Errc::Faulted;
}

/// Tells how much room a queued command has at its provider, for a client that has many to send.
///   while (arm_.append.room() > 0 && path.more()) arm_.append(path.next());      a control loop
///   if (arm_.append.roomWithin(20ms)) arm_.append(path.next());                  where it may wait
class QueuedCommand {
 public:
  QueuedCommand(RequiredParts& required, std::uint16_t id) : required_(required), id_(id) {}

  /// Never blocks. Returns how many of this command the provider's queue takes now, before one is
  /// refused with Errc::Full. It is 0 if calls cannot reach the provider, and the largest number
  /// where there is no limit: for latest() without an answer, and for a command in the caller's
  /// thread. After 0, the component is rung when the provider has executed what waits: an event
  /// task runs again, a device asks roomWithin(). The number of calls that may be under way limits
  /// calls with an answer, too.
  std::uint32_t room() { return required_.sender.room(id_); }

  /// Waits at most `limit` until there is room, and returns how much. Answers Errc::Timeout, or why
  /// calls cannot reach the provider. It is not for a periodic task, which would miss its period.
  Result<std::uint32_t> roomWithin(Duration limit) {
    return required_.sender.roomWithin(id_, limit);
  }

 protected:
  RequiredParts& required_;
  std::uint16_t id_;
};

/// This is a void or write command: queued at the provider, executed in its thread. A direct() one,
/// and any of a device, is executed at once in the caller's thread if both are in one process.
///   slave_.servo_cp(goal);                        queued; the answer says if it was
///   auto call = slave_.servo_cp.start(goal);      the same, and learns when it has been executed
/// Belongs to the thread of the component that requires the interface; another thread gets
/// Errc::WrongThread.
template <auto Method, class ArgumentsSlot>
class Command;

// `Nothing` is void; see resultOf().
template <class Contract, class Nothing, class... Arguments,
          Nothing (Contract::*Method)(Arguments...), class ArgumentsSlot>
class Command<Method, ArgumentsSlot> : public QueuedCommand {
 public:
  using QueuedCommand::QueuedCommand;

  /// Never blocks, unless the command runs in this thread and blocks; never allocates in a task's
  /// thread, and in another one only for its first arguments of more than 4 KiB. Success means that
  /// the command waits at the provider (local), is on its way within the provider's credit (any
  /// other lane), or has run (in this thread). Every error means that it has not run and will not
  /// run, except Faulted if it ran in this thread and threw. On every lane the errors are
  ///   WrongThread, NotConnected, Lost, Suspended, Faulted   it cannot reach the provider now
  ///   NotImplemented      the provider was built without it
  ///   AwaitingOperator    its provider was lost or faulted, and an operator has to resume it
  ///   Full                as many of this command wait as its queue takes; see room()
  ///   TooLarge, Invalid   an argument exceeds its capacity, or the contract does not admit it
  ///   OnLoan              it was sent from within the filling of a loan(); see there
  /// Reports count what becomes of it later (Late, Superseded, NotPermitted ...), and start() tells
  /// it.
  Result<Nothing> operator()(Arguments... arguments) {
    return resultOf<Nothing>(send(0, arguments...));
  }

  /// Does what operator() does with a command of one argument, one list of which is written where
  /// it leaves from, without a copy: in memory that processes share, if that is the lane. `List` is
  /// a member of the argument's slot, or several that lead to it.
  ///   viewer_.show.loan<&FrameSlot::pixels>(frame, [&](std::span<std::uint8_t> room) {
  ///     return camera_.grab(room);                           returns how many it has written
  ///   });
  /// `rest` has everything else; leave the list empty in it. The room has any old bytes, and
  /// another process may change it: write it only. The command's age begins before `fill` does.
  /// While it runs, other commands of this interface answer Errc::OnLoan, and so do fresh reads. If
  /// `fill` throws, or the provider cannot be reached when it returns, nothing is sent. A command
  /// that runs in this thread allocates its argument. Errors are those of operator().
  template <auto... List, class Fill>
  Result<Nothing> loan(Arguments... rest, const Fill& fill) {
    static_assert(sizeof...(Arguments) == 1, "a loan is for a command with one argument");
    const auto storeAll = [&](ArgumentsSlot& slot) {
      return store(rest..., slot) && fillList(listIn<List...>(onlyMember(slot)), fill);
    };
    if (const Errc error = required_.attachment.unusable(id_); error != Errc{})
      return resultOf<Nothing>(error);
    if (ProvidedBase* const callee = required_.sender.callee(id_))
      return resultOf<Nothing>(lendHere(*callee, storeAll));
    return resultOf<Nothing>(required_.sender.lend(
        id_, [&](std::byte* memory) { return storeAll(newSlot<ArgumentsSlot>(memory)); }));
  }

  /// Does the same as operator(), and the call is answered when the command has been executed or
  /// has come to another end. Errors are those of operator(), as the answer of a call that has
  /// ended already; and Errc::TooManyCalls if no place for a call is free.
  [[nodiscard]] Call<Result<Nothing>, NoSlot> start(Arguments... arguments) {
    if (const Errc error = required_.attachment.unusable(id_); error != Errc{}) return error;
    if (ProvidedBase* const callee = required_.sender.callee(id_)) {
      return resultOf<Nothing>(callHere(*callee, arguments...));
    }
    auto* pending = required_.calls.open(id_);
    if (pending == nullptr) return Errc::TooManyCalls;
    return {required_.calls, *pending, required_.sender.deadlineOf(id_),
            send(pending->number, arguments...)};
  }

 private:
  Errc callHere(ProvidedBase& callee, Arguments... arguments) {
    const Errc error = required_.sender.judgeHere<ArgumentsSlot>(id_, arguments...);
    return error == Errc{} ? runCounted(callee, arguments...) : error;
  }

  template <class Store>
  Errc lendHere(ProvidedBase& callee, const Store& storeAll) {
    std::tuple<std::remove_cvref_t<Arguments>...> arguments;
    {
      LooseSlot<ArgumentsSlot> slot;  // the handler finds this thread's memory free again
      const Errc error =
          required_.sender.lendHere(id_, slot.memory(), [&] { return storeAll(slot.value()); });
      if (error != Errc{}) return error;
      load(onlyMember(slot.value()), std::get<0>(arguments));
    }
    return runCounted(callee, std::get<0>(arguments));
  }

  template <class... Values>
  Errc runCounted(ProvidedBase& callee, Values&... arguments) {
    return required_.sender.countHere(
        runHere<Contract>(callee, [&](Contract& contract) { (contract.*Method)(arguments...); }));
  }

  Errc send(std::uint32_t call, Arguments... arguments) {
    if (const Errc error = required_.attachment.unusable(id_); error != Errc{}) return error;
    if (ProvidedBase* const callee = required_.sender.callee(id_))
      return callHere(*callee, arguments...);
    return required_.sender.send(id_, call, [&]([[maybe_unused]] std::byte* memory) {
      if constexpr (sizeof...(Arguments) == 0) {
        return true;
      } else {
        return store(arguments..., newSlot<ArgumentsSlot>(memory));
      }
    });
  }
};

/// This is a read command: it copies the newest value that the provider produced, and waits for no
/// one.
///   const auto pose = master_.measured_cp();             Sample<PoseStamped>
///   master_.measured_js(state);                          into an object that keeps its memory
///   master_.measured_cp.at(frame.stamp)                  as it was then
///   master_.measured_cp.delayed(10ms)                    as it was 10 ms ago
///   auto call = master_.measured_cp.fresh();             evaluated by the provider for this call
/// readTogether() (read_together.h) reads several of one row.
/// Belongs to the thread of the component that requires the interface; another thread gets
/// Errc::WrongThread.
template <auto Method, class ResultSlot>
class ReadCommand;

template <class Contract, class ReturnType, ReturnType (Contract::*Method)() const,
          class ResultSlot>
class ReadCommand<Method, ResultSlot> {
 public:
  using Value = std::remove_cvref_t<ReturnType>;

  ReadCommand(RequiredParts& required, std::uint16_t id) : required_(required), id_(id) {}

  /// Returns the newest value. It is Errc::NotYet until the provider has produced one; the first
  /// read makes the provider do so from then on. It is Errc::Invalid while the contract does not
  /// admit what the provider produces, but the values of a device in this process are not checked.
  /// Allocates only if Value does, or for the first value of more than 4 KiB in a thread that is no
  /// task's.
  Sample<Value> operator()() {
    Value value{};
    const Sample<void> read = (*this)(value);
    return {read, std::move(value)};
  }

  /// Reads into `value`, which keeps its memory, and is unchanged if the sample carries no value.
  Sample<void> operator()(Value& value) {
    LooseSlot<ResultSlot> slot;
    bool device = false;
    const Sample<void> read = required_.reads.read(id_, slot.memory(), device);
    if (device) return readDevice(value);
    if (required_.reads.zeroes(read)) {
      load(slot.zero(), value);  // not Value{}: Eigen leaves that uninitialised
    } else if (read.carriesValue()) {
      load(slot.value(), value);
    }
    return read;
  }

  /// Any thread, before its task starts. Gives `value` the memory of the largest value there can
  /// be, so that not even the first read into it allocates. Elements such as the strings of a
  /// vector may still allocate.
  static void reserve(Value& value) { reserveFor<ResultSlot>(value); }

  /// Returns the value as it was at `time`: that of the last row published at or before it, with
  /// the row's stamp. It is Errc::TooOld if the provider keeps no row so old
  /// (ProvidedBase::keepState), or is a device in this process, which keeps none; it is NotYet if
  /// the provider had not produced the value by then. On other lanes than `local` the rows are
  /// those that arrived.
  Sample<Value> at(Time time) {
    Value value{};
    const Sample<void> read = at(time, value);
    if (!read) return read.error();
    return {std::move(value), read.stamp()};
  }
  /// Reads into `value`, which keeps its memory, and is unchanged if there is no value.
  Sample<void> at(Time time, Value& value) {
    LooseSlot<ResultSlot> slot;
    bool device = false;
    const Sample<void> read = required_.reads.readAt(time, id_, slot.memory(), device);
    if (device) return readDevice(value);
    if (read) load(slot.value(), value);
    return read;
  }

  /// Returns the value as it was `delay` ago; see at().
  Sample<Value> delayed(Duration delay) { return at(ago(delay)); }
  /// Does the same into `value`, which keeps its memory, and is unchanged if there is no value.
  Sample<void> delayed(Duration delay, Value& value) { return at(ago(delay), value); }

  /// Never blocks. Makes the provider evaluate the value in its own thread, for this call alone; of
  /// a device in this process, and of a command that runs in the caller's thread, the value is read
  /// at once. Errors are those of Command::start().
  [[nodiscard]] Call<Sample<Value>, ResultSlot> fresh() {
    if (const Errc error = required_.attachment.unusable(id_); error != Errc{}) return error;
    if (required_.sender.callee(id_) != nullptr) return (*this)();
    auto* pending = required_.calls.open(id_);
    if (pending == nullptr) return Errc::TooManyCalls;
    return {required_.calls, *pending, required_.sender.deadlineOf(id_),
            required_.sender.send(id_, pending->number, [](std::byte*) { return true; })};
  }

 private:
  friend class RowReader;
  using Slot = ResultSlot;

  Sample<void> readDevice(Value& value) {
    const Errc error = runHere<const Contract>(
        *required_.sender.callee(id_),
        [&](const Contract& contract) { copy((contract.*Method)(), value); });
    if (error != Errc{}) return error;
    return Sample<void>(now());
  }

  static void copy(ReturnType result, Value& value) {
    if constexpr (std::is_assignable_v<Value&, ReturnType>) {
      value = std::forward<ReturnType>(result);
    } else {  // the result contains a std::unique_ptr, but its slot does not
      LooseSlot<ResultSlot> slot;
      store(result, slot.value());
      load(slot.value(), value);
    }
  }

  RequiredParts& required_;
  std::uint16_t id_;
};

/// This is the common part of qualified reads and commands with a return value: `Method` runs on
/// the arguments, and its result is the answer.
///   auto call = slave_.inverse_kinematics.start(pose);   look at call.poll() in a control loop
///   call.within(20ms)                                    or wait, for a bounded time
/// Belongs to the thread of the component that requires the interface; another thread gets
/// Errc::WrongThread.
template <class Contract, auto Method, class ArgumentsSlot, class ResultSlot, class ReturnType,
          class... Arguments>
class AnsweredCommand : public QueuedCommand {
 public:
  using Value = std::remove_cvref_t<ReturnType>;

  using QueuedCommand::QueuedCommand;

  /// Sends the command and returns the call, whose answer is the result. Never blocks and never
  /// allocates in a task's thread, as Command::operator() does not, but the result may own memory
  /// when it is taken from the call. A command that runs in the caller's thread has run when this
  /// returns, and its answer is here. Errors are those of Command::start(), as the answer of a call
  /// that has ended already; a result that exceeds its capacity, or that the contract does not
  /// admit, is answered as Errc::TooLarge or Errc::Invalid although the command has run.
  [[nodiscard]] Call<Result<Value>, ResultSlot> start(Arguments... arguments) {
    if (const Errc error = required_.attachment.unusable(id_); error != Errc{}) return error;
    if (ProvidedBase* const callee = required_.sender.callee(id_))
      return askHere(*callee, arguments...);
    auto* pending = required_.calls.open(id_);
    if (pending == nullptr) return Errc::TooManyCalls;
    return {required_.calls, *pending, required_.sender.deadlineOf(id_),
            required_.sender.send(id_, pending->number, [&]([[maybe_unused]] std::byte* memory) {
              if constexpr (sizeof...(Arguments) == 0) {
                return true;
              } else {
                return store(arguments..., newSlot<ArgumentsSlot>(memory));
              }
            })};
  }

 private:
  Result<Value> askHere(ProvidedBase& callee, Arguments... arguments) {
    Value value{};
    Errc error = required_.sender.judgeHere<ArgumentsSlot>(id_, arguments...);
    if (error == Errc{}) {
      error = required_.sender.countHere(runHere<Contract>(
          callee, [&](Contract& contract) { value = (contract.*Method)(arguments...); }));
    }
    if (error == Errc{}) error = required_.sender.judgeResultHere<ResultSlot>(id_, value);
    return error == Errc{} ? Result<Value>(std::move(value)) : Result<Value>(tl::unexpect, error);
  }
};

/// This is a qualified read: a question with arguments, which changes nothing at the provider. A
/// concurrent() one, and any of a device, is answered at once in the caller's thread if both are in
/// one process.
template <auto Method, class ArgumentsSlot, class ResultSlot>
class QualifiedReadCommand;

template <class Contract, class ReturnType, class... Arguments,
          ReturnType (Contract::*Method)(Arguments...) const, class ArgumentsSlot, class ResultSlot>
class QualifiedReadCommand<Method, ArgumentsSlot, ResultSlot>
    : public AnsweredCommand<const Contract, Method, ArgumentsSlot, ResultSlot, ReturnType,
                             Arguments...> {
 public:
  using QualifiedReadCommand::AnsweredCommand::AnsweredCommand;
};

/// This is a void or write command that returns a value. It is queued like any other, and the
/// answer has what it returned.
template <auto Method, class ArgumentsSlot, class ResultSlot>
class ReturningCommand;

template <class Contract, class ReturnType, class... Arguments,
          ReturnType (Contract::*Method)(Arguments...), class ArgumentsSlot, class ResultSlot>
class ReturningCommand<Method, ArgumentsSlot, ResultSlot>
    : public AnsweredCommand<Contract, Method, ArgumentsSlot, ResultSlot, ReturnType,
                             Arguments...> {
 public:
  using ReturningCommand::AnsweredCommand::AnsweredCommand;
};

}  // namespace suture
