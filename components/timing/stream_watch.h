#pragma once
// This tells when a command that must be repeated is not repeated any more.

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// One thread.
class StreamWatch {
 public:
  static constexpr suture::Duration kSilence = std::chrono::milliseconds(100);

  /// Says that the command has come, again or for the first time.
  void ask() { asked_ = active_ = true; }
  /// Says that the command need not come any more.
  void end() { asked_ = active_ = false; }
  /// Returns true from when the command has come until end().
  bool isActive() const { return active_; }

  /// Call this once a cycle. Returns true if the command has not come for too long.
  bool hasFallenSilent(suture::Time now) {
    if (asked_) lastAsked_ = now;
    asked_ = false;
    return active_ && now - lastAsked_ > kSilence;
  }

 private:
  bool active_ = false;
  bool asked_ = false;        // since the last cycle
  suture::Time lastAsked_{};  // the cycle in which it came
};

}  // namespace robots
