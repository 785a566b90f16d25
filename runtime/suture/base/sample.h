#pragma once
// A read answers with a sample: a value with its stamp, or the reason why there is none.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <utility>

namespace suture {

/// Holds a value that a component produced at a known time. It belongs to the thread that read it.
template <class T>
class Sample;

/// Answers a read into the caller's own object: it has only the stamp, or the reason.
template <>
class Sample<void> {
 public:
  Sample(Errc error) : error_(error) {}  // NOLINT: converts on purpose
  explicit Sample(Time stamp) : stamp_(stamp), usable_(true) {}
  /// `stamp` is that of the last value; if `usable`, the caller may act on that value despite the
  /// error.
  Sample(Errc error, Time stamp, bool usable) : stamp_(stamp), error_(error), usable_(usable) {}

  /// Returns true if there is a value to act on.
  bool hasValue() const { return usable_; }
  explicit operator bool() const { return usable_; }
  /// Return what the members of these names return in Sample<T>.
  Time stamp() const { return stamp_; }
  Duration age() const { return carriesValue() ? since(stamp_) : Duration::max(); }
  Errc error() const { return error_; }
  /// Returns true if there is a value, either to act on or only to look at.
  bool carriesValue() const { return toNanoseconds(stamp_) != 0; }

 private:
  Time stamp_{};
  Errc error_{};
  bool usable_ = false;
};

template <class T>
class Sample {
 public:
  Sample(Errc error) : answer_(error) {}  // NOLINT: converts on purpose, like tl::unexpected
  Sample(T value, Time stamp) : value_(std::move(value)), answer_(stamp) {}
  Sample(const Sample<void>& answer, T value) : value_(std::move(value)), answer_(answer) {}

  /// Returns true if there is a value to act on.
  bool hasValue() const { return answer_.hasValue(); }
  explicit operator bool() const { return hasValue(); }

  /// Returns the value. Call it only if carriesValue().
  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  /// Returns when the provider produced the value, on this process's clock.
  Time stamp() const { return answer_.stamp(); }
  /// Returns how old the value is now, on this process's clock; Duration::max() without a value, so
  /// that a test for too great an age holds for it too.
  Duration age() const { return answer_.age(); }
  /// Returns why there is no value to act on, or 0 if there is one. It is Errc::Stale or Errc::Lost
  /// also for a value that the connection's contract lets pass or replaces by zero
  /// (docs/safety.md).
  Errc error() const { return answer_.error(); }
  /// Returns true if there is a value. If hasValue() is false, it is the last one: look at it, but
  /// do not act on it.
  bool carriesValue() const { return answer_.carriesValue(); }

 private:
  T value_{};
  Sample<void> answer_;
};

}  // namespace suture
