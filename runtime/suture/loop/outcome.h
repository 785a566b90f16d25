#pragma once
// This is the result of work done on the control thread, for the thread that waits for it.

#include <kj/async.h>
#include <suture/base/time.h>
#include <suture/loop/failure.h>
#include <suture/rt/doorbell.h>

#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace suture::loop {

/// ControlThread::run() throws this when there is no result.
class ControlFailure : public std::runtime_error {
 public:
  enum class Kind { Failed, TimedOut, Stopped };
  ControlFailure(Kind kind, const std::string& text) : runtime_error(text), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// Holds a value or a failure, set once by any thread, for one thread that waits.
template <class T>
class Outcome {
 public:
  using Stored = std::conditional_t<std::is_void_v<T>, std::monostate, T>;

  void succeed(Stored value) {
    settle([&] { value_.emplace(std::move(value)); });
  }
  void fail(ControlFailure::Kind kind, const std::string& text) {
    settle([&] {
      failure_ = kind;
      text_ = text;
    });
  }

  /// Waits 1 s longer than `deadline`, because at the deadline the control thread itself settles,
  /// unless it hangs.
  T wait(Duration deadline) {
    constexpr Duration kLater = std::chrono::seconds(1);
    const Time late =
        deadline < Duration::max() - kLater ? fromNow(deadline + kLater) : Time::max();
    while (settled_.waitUntil(late) == rt::RungFor::Nothing && now() < late) {
    }
    const std::lock_guard lock(mutex_);
    if (failure_) throw ControlFailure(*failure_, text_);
    if (!value_) throw ControlFailure(ControlFailure::Kind::TimedOut, "the control thread hangs");
    if constexpr (!std::is_void_v<T>) return std::move(*value_);
  }

 private:
  template <class Set>
  void settle(Set set) {
    const std::lock_guard lock(mutex_);
    if (value_ || failure_) return;
    set();
    settled_.ring();
  }

  std::mutex mutex_;
  rt::Doorbell settled_;
  std::optional<Stored> value_;
  std::optional<ControlFailure::Kind> failure_;
  std::string text_;
};

/// This is the obligation to settle an outcome: if it is destroyed first, the waiter learns that
/// the thread stopped.
template <class T>
class Settles {
 public:
  explicit Settles(std::shared_ptr<Outcome<T>> outcome) : outcome_(std::move(outcome)) {}
  Settles(Settles&&) noexcept = default;
  ~Settles() {
    if (outcome_) outcome_->fail(ControlFailure::Kind::Stopped, "the control thread has stopped");
  }

  /// Settles with the result of `promise`.
  kj::Promise<void> follow(kj::Promise<T> promise) {
    auto outcome = outcome_;
    auto failed = [outcome](kj::Exception&& e) {
      const bool late = e.getType() == kj::Exception::Type::OVERLOADED;
      outcome->fail(late ? ControlFailure::Kind::TimedOut : ControlFailure::Kind::Failed,
                    describe(e));
    };
    return succeedWith(kj::mv(promise), kj::mv(failed)).attach(kj::mv(*this));
  }

 private:
  template <class Failed>
  kj::Promise<void> succeedWith(kj::Promise<T> promise, Failed failed) {
    auto outcome = outcome_;
    if constexpr (std::is_void_v<T>) {
      return promise.then([outcome] { outcome->succeed({}); }, kj::mv(failed));
    } else {
      return promise.then([outcome](T&& value) { outcome->succeed(kj::mv(value)); },
                          kj::mv(failed));
    }
  }

  std::shared_ptr<Outcome<T>> outcome_;
};

}  // namespace suture::loop
