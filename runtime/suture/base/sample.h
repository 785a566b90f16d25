#pragma once
// What a read answers: a value with its stamp, or the reason why there is none.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <utility>

namespace suture {

/// A value that a component produced at a known time. A value type of the thread that read it.
template <class T>
class Sample;

/// The answer of a read into the caller's own object: only the stamp, or the reason.
template <>
class Sample<void> {
 public:
  Sample(Errc error) : error_(error) {}  // NOLINT: converts on purpose
  explicit Sample(Time stamp) : stamp_(stamp), usable_(true) {}
  /// `stamp`: of the last value there was; `usable`: it may be acted upon all the same.
  Sample(Errc error, Time stamp, bool usable) : stamp_(stamp), error_(error), usable_(usable) {}

  /// True if there is a value to act on.
  bool hasValue() const { return usable_; }
  explicit operator bool() const { return usable_; }
  Time stamp() const { return stamp_; }
  Duration age() const { return since(stamp_); }
  Errc error() const { return error_; }
  /// True if some value came along, to be acted on or only to be looked at.
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

  /// True if there is a value to act on.
  bool hasValue() const { return answer_.hasValue(); }
  explicit operator bool() const { return hasValue(); }

  /// The value. Only when carriesValue().
  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  /// When the provider produced the value, on this process's clock.
  Time stamp() const { return answer_.stamp(); }
  /// How old the value is now, on this process's clock.
  Duration age() const { return answer_.age(); }
  /// Why there is no value to act on; 0 if there is. With a value that the connection's contract
  /// lets pass or replaces by zero (docs/safety.md): Errc::Stale or Errc::Lost all the same.
  Errc error() const { return answer_.error(); }
  /// True if some value came along: where hasValue() is false, the last there was, to be looked at
  /// and not acted on.
  bool carriesValue() const { return answer_.carriesValue(); }

 private:
  T value_{};
  Sample<void> answer_;
};

}  // namespace suture
