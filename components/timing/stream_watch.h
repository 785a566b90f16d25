#pragma once
// Tells when a command that has to be repeated is repeated no more.

#include <suture/base/time.h>

#include <chrono>

namespace robots {

/// It is confined to one thread.
class StreamWatch {
 public:
  static constexpr suture::Duration kSilence = std::chrono::milliseconds(100);

  /// The command has come, again or for the first time.
  void ask() { asked_ = active_ = true; }
  /// The command need not come any more.
  void end() { asked_ = active_ = false; }

  /// Counts a cycle; true: it has not come for too long.
  bool hasFallenSilent(suture::Time now) {
    if (asked_) lastAsked_ = now;
    asked_ = false;
    return active_ && now - lastAsked_ > kSilence;
  }

 private:
  bool active_ = false;
  bool asked_ = false;        // since the last cycle
  suture::Time lastAsked_{};  // the cycle that it came in
};

}  // namespace robots
