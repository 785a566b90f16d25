#pragma once
// This follows a call whose answer comes later.

#include <suture/base/sample.h>
#include <suture/base/slots/shared_slot.h>
#include <suture/component/required/calls.h>

#include <new>
#include <type_traits>
#include <utility>

namespace suture {

/// NoSlot is the slot of something that has no value.
struct NoSlot {};

/// Says what an answer holds, and how it tells that it has no value.
template <class Answer>
struct AnswerTraits;

template <class T>
struct AnswerTraits<Sample<T>> {
  using Value = T;
  static Sample<T> error(Errc error) { return error; }
  static Sample<T> success(T value, Time stamp) { return {std::move(value), stamp}; }
};

template <class T>
struct AnswerTraits<Result<T>> {
  using Value = T;
  static Result<T> error(Errc error) { return Result<T>{tl::unexpect, error}; }
  template <class Found>
  static Result<T> success(Found value, Time) {
    return value;
  }
};

/// Holds the part of Call that does not depend on what is called.
class CallBase {
 protected:
  CallBase() = default;
  CallBase(Calls& calls, PendingCall& pending, Duration limit)
      : calls_(&calls), pending_(&pending), limit_(limit) {}
  CallBase(CallBase&& other) noexcept;
  CallBase& operator=(CallBase&& other) noexcept;
  ~CallBase() { close(); }

  bool done();
  void waitUntilDone(Duration limit) { calls_->waitFor(*pending_, limit); }
  /// Cancels the call at the provider, and closes it. Returns false if that came too late.
  bool takeBack();
  /// Closes the call, whose wait is over, and returns the error that it ends with.
  Errc giveUp();
  /// Lets `follower` be called when the answer is here.
  void passOnTo(PendingCall::Follower follower);
  /// Ends the call, because its answer has been read or is no longer wanted.
  void close();

  Calls* calls_ = nullptr;
  PendingCall* pending_ = nullptr;
  Duration limit_ = kDefaultDeadline;
};

/// Belongs to the thread that started the call, and must not outlive the required interface.
/// Follows one call to its answer: by poll() in a control loop, or by within() where blocking for a
/// bounded time is right. Destroying it abandons the call; the provider may still execute it.
template <class Answer, class Slot>
class [[nodiscard]] Call : CallBase {
 public:
  Call(Errc error) : answer_(Traits::error(error)), ended_(true) {}  // NOLINT: converts on purpose
  Call(Answer answer) : answer_(std::move(answer)), ended_(true) {}  // NOLINT: as well
  /// `limit` says how long within() waits if it gets no limit.
  Call(Calls& calls, PendingCall& pending, Duration limit, Errc sent)
      : CallBase(calls, pending, limit) {
    if (sent == Errc{}) return;
    pending.done = true;  // no answer will come
    close();
    end(Traits::error(sent));
  }

  /// Returns the answer if it is here, else null. Never blocks. The answer is part of the call, so
  /// keep the call.
  const Answer* poll() & {
    if (!ended_ && done()) take();
    return ended_ ? &answer_ : nullptr;
  }
  const Answer* poll() && = delete;

  /// Waits at most `limit` for the answer and returns it, or Errc::Timeout. There is no way to wait
  /// without a limit. If the component is stopped meanwhile, other than in a hook, the wait ends:
  /// with Errc::Cancelled if the command is not executed, else with OutcomeUnknown.
  const Answer& within(Duration limit) & {
    if (!ended_) {
      waitUntilDone(limit);
      if (!poll()) end(Traits::error(giveUp()));
    }
    return answer_;
  }
  /// Waits as long as the deadline of the connection's contract, else the command's deadline(),
  /// else kDefaultDeadline.
  const Answer& within() & { return within(limit_); }
  /// Waits likewise, and returns the answer of a call that nobody keeps.
  Answer within(Duration limit) && {
    within(limit);
    return std::move(answer_);
  }
  /// Does the same with the deadline of the other within().
  Answer within() && { return std::move(*this).within(limit_); }

  /// Never blocks. Takes the command back: returns true if it will not be executed; then
  /// Errc::Cancelled is the answer. Returns false, and changes nothing, if it runs or has run, has
  /// been answered, or has left this process or entered a delay; the answer still comes.
  [[nodiscard]] bool cancel() {
    if (poll() || !takeBack()) return false;
    end(Traits::error(Errc::Cancelled));
    return true;
  }

  /// Use this instead of poll() and within(). Calls `handler(const Answer&)` once, in this thread,
  /// when the answer is here or the connection has ended: before run(), or in a device's
  /// processEvents(); at once if the call has ended already, for example because it was refused.
  /// Allocates nothing: what `handler` captures is a few pointers and numbers, copied as bytes.
  ///   slave_.move.start(goal, 1, "").then([this](const Result<bool>& reached) { ... });
  template <class Handler>
  void then(Handler handler) && {
    static_assert(sizeof(Handler) <= PendingCall::kHandlerSize, "capture a pointer to it instead");
    static_assert(
        std::is_trivially_copyable_v<Handler> && std::is_trivially_destructible_v<Handler>,
        "capture pointers and numbers only: the handler is copied as bytes");
    if (poll()) return handler(answer_);
    new (pending_->handler) Handler(handler);
    passOnTo(&finish<Handler>);
  }

 private:
  using Traits = AnswerTraits<Answer>;

  template <class Handler>
  static void finish(Calls& calls, PendingCall& pending) {
    // Copy the handler: if it starts another call, that call may get this place.
    const Handler handler = *std::launder(reinterpret_cast<Handler*>(pending.handler));
    Call call(calls, pending, kDefaultDeadline, Errc{});
    handler(*call.poll());
  }

  void take() {
    if (pending_->error != Errc{}) {
      end(Traits::error(pending_->error));
    } else if constexpr (std::is_same_v<Slot, NoSlot>) {
      end(Answer{});
    } else {
      typename Traits::Value value{};
      load(slotIn<Slot>(pending_->result.data()), value);
      end(Traits::success(std::move(value), pending_->stamp));
    }
    close();
  }

  void end(Answer&& answer) {
    answer_ = std::move(answer);
    ended_ = true;
  }

  Answer answer_ = Traits::error(Errc::NotYet);
  bool ended_ = false;
};

}  // namespace suture
