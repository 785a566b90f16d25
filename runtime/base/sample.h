#pragma once
// What a read answers: a value with its stamp, or the reason why there is none.

#include <suture/base/errors.h>
#include <suture/base/time.h>

#include <utility>

namespace suture {

/// A value that a component produced at a known time. A value type of the thread that read it.
template <class T>
class Sample {
 public:
  Sample(Errc error) : error_(error) {}  // NOLINT: converts on purpose, like tl::unexpected
  Sample(T value, Time stamp) : value_(std::move(value)), stamp_(stamp) {}

  bool hasValue() const { return stamp_ != Time{}; }
  explicit operator bool() const { return hasValue(); }

  /// The value. Only when hasValue().
  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  /// When the provider produced the value, on this process's clock.
  Time stamp() const { return stamp_; }
  /// How old the value is now, on this process's clock.
  Duration age() const { return now() - stamp_; }
  /// Why there is no value. Only when !hasValue().
  Errc error() const { return error_; }

 private:
  T value_{};
  Time stamp_{};
  Errc error_{};
};

/// The answer of a read into the caller's own object: only the stamp, or the reason.
template <>
class Sample<void> {
 public:
  Sample(Errc error) : error_(error) {}  // NOLINT: converts on purpose
  explicit Sample(Time stamp) : stamp_(stamp) {}

  bool hasValue() const { return stamp_ != Time{}; }
  explicit operator bool() const { return hasValue(); }
  Time stamp() const { return stamp_; }
  Duration age() const { return now() - stamp_; }
  Errc error() const { return error_; }

 private:
  Time stamp_{};
  Errc error_{};
};

}  // namespace suture
