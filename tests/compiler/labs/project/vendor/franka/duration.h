// This has the shape of libfranka's franka/duration.h: a count that is hidden.
#pragma once

#include <chrono>
#include <cstdint>

namespace franka {

class Duration {
 public:
  Duration() noexcept : duration_{0} {}
  explicit Duration(uint64_t milliseconds) noexcept : duration_{milliseconds} {}
  Duration(std::chrono::duration<uint64_t, std::milli> duration) noexcept : duration_{duration} {}
  Duration(const Duration&) = default;
  Duration& operator=(const Duration&) = default;

  operator std::chrono::duration<uint64_t, std::milli>() const noexcept { return duration_; }
  double toSec() const noexcept { return static_cast<double>(duration_.count()) / 1000; }
  uint64_t toMSec() const noexcept { return duration_.count(); }

  Duration operator+(const Duration& rhs) const noexcept { return duration_ + rhs.duration_; }
  Duration& operator+=(const Duration& rhs) noexcept {
    duration_ += rhs.duration_;
    return *this;
  }
  bool operator==(const Duration& rhs) const noexcept { return duration_ == rhs.duration_; }
  bool operator<(const Duration& rhs) const noexcept { return duration_ < rhs.duration_; }

 private:
  std::chrono::duration<uint64_t, std::milli> duration_;
};

}  // namespace franka
