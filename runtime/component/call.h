#pragma once
// A call whose answer comes later.

#include <suture/base/sample.h>
#include <suture/base/shared_slot.h>
#include <suture/component/required.h>

#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace suture {

/// The slot of something that has no value.
struct NoSlot {};

/// What an answer holds, and how it says that there is none.
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
  static Result<T> error(Errc error) { return tl::unexpected(error); }
  template <class Found>
  static Result<T> success(Found value, Time) {
    return value;
  }
};

/// Follows one call to its answer: by poll() in a control loop, or by within() where blocking for a
/// bounded time is right. Destroying it abandons the call; the provider may still execute it.
/// Belongs to the thread that started the call and must not outlive the required interface.
template <class Answer, class Slot>
class [[nodiscard]] Call {
 public:
  Call(Errc error) : answer_(Traits::error(error)) {}  // NOLINT: converts on purpose
  Call(Answer answer) : answer_(std::move(answer)) {}  // NOLINT: converts on purpose
  /// `limit`: how long within() waits when it is not told.
  Call(RequiredBase& required, RequiredBase::PendingCall& pending, Duration limit, Errc sent)
      : required_(&required), pending_(&pending), limit_(limit) {
    if (sent != Errc{}) {
      answer_ = Traits::error(sent);
      required.discard(pending);
      pending_ = nullptr;
    }
  }
  Call(Call&& other) noexcept
      : required_(other.required_),
        pending_(std::exchange(other.pending_, nullptr)),
        limit_(other.limit_),
        answer_(std::move(other.answer_)) {}
  Call& operator=(Call&& other) noexcept {
    std::swap(required_, other.required_);
    std::swap(pending_, other.pending_);
    std::swap(limit_, other.limit_);
    std::swap(answer_, other.answer_);
    return *this;
  }
  ~Call() {
    if (pending_ != nullptr) required_->closeCall(*pending_);
  }

  /// The answer if it is here. Never blocks.
  const std::optional<Answer>& poll() {
    if (!answer_ && required_->isDone(*pending_)) take();
    return answer_;
  }

  /// The answer, waiting at most `limit` for it: Errc::Timeout if it does not come. There is no way
  /// to wait without a limit.
  const Answer& within(Duration limit) {
    if (!answer_) {
      required_->waitFor(*pending_, limit);
      if (!poll()) answer_ = Traits::error(Errc::Timeout);
    }
    return *answer_;
  }
  /// The same with the deadline() that the contract states for the command, else kDefaultDeadline.
  const Answer& within() { return within(limit_); }

  /// Takes the command back: true if it will not be executed, and Errc::Cancelled is the answer.
  /// False: it is being executed or has been, or has left for another process or been answered;
  /// then nothing changes, and the answer still comes. Never blocks.
  [[nodiscard]] bool cancel() {
    if (poll() || !required_->cancel(*pending_)) return false;
    required_->closeCall(*std::exchange(pending_, nullptr));
    answer_ = Traits::error(Errc::Cancelled);
    return true;
  }

  /// Instead of poll() and within(): `handler(const Answer&)` is called once, in this thread, when
  /// the answer is here or the connection has ended: before run(), or by a device's
  /// processEvents(); at once if the call has ended by now, as one that was refused. Nothing is
  /// allocated: what `handler` captures is a few pointers and numbers, copied as bytes.
  ///   slave_.move.start(goal, 1, "").then([this](const Result<bool>& reached) { ... });
  template <class Handler>
  void then(Handler handler) && {
    static_assert(sizeof(Handler) <= RequiredBase::kHandlerSize, "capture a pointer to it instead");
    static_assert(
        std::is_trivially_copyable_v<Handler> && std::is_trivially_destructible_v<Handler>,
        "capture pointers and numbers only: the handler is copied as bytes");
    if (poll()) return handler(*answer_);
    new (pending_->handler) Handler(handler);
    required_->follow(*std::exchange(pending_, nullptr), &finish<Handler>);
  }

 private:
  using Traits = AnswerTraits<Answer>;

  template <class Handler>
  static void finish(RequiredBase& required, RequiredBase::PendingCall& pending) {
    // Whoever starts the next call in the handler may get this place.
    const Handler handler = *std::launder(reinterpret_cast<Handler*>(pending.handler));
    Call call(required, pending, kDefaultDeadline, Errc{});
    handler(*call.poll());
  }

  void take() {
    if (pending_->error != Errc{}) {
      answer_ = Traits::error(pending_->error);
    } else if constexpr (std::is_same_v<Slot, NoSlot>) {
      answer_ = Answer{};
    } else {
      typename Traits::Value value{};
      load(slotIn<Slot>(pending_->result.data()), value);
      answer_ = Traits::success(std::move(value), pending_->stamp);
    }
    required_->closeCall(*pending_);
    pending_ = nullptr;
  }

  RequiredBase* required_ = nullptr;
  RequiredBase::PendingCall* pending_ = nullptr;
  Duration limit_ = kDefaultDeadline;
  std::optional<Answer> answer_;
};

}  // namespace suture
