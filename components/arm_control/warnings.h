#pragma once
// An arm keeps its warnings here until it tells them at the end of a cycle.

#include <cstdint>
#include <string_view>

#include "arm/arm_warning.h"

namespace robots {

/// What an arm says of it, for people.
std::string_view textOf(ArmWarning reason);

/// It has befallen one joint, whose name stands before the text.
constexpr bool isOfJoint(ArmWarning reason) {
  return reason == ArmWarning::FollowingError || reason == ArmWarning::EncoderJump ||
         reason == ArmWarning::OverCurrent;
}

/// Collects what is to be told at the end of a cycle. Confined to one thread; never allocates.
class Warnings {
 public:
  /// Tells it once, until the arm obeys again.
  void warn(ArmWarning reason) {
    if ((standing_ & bit(reason)) == 0) news_ |= bit(reason);
    standing_ |= bit(reason);
  }
  /// Tells it each time.
  void tell(ArmWarning reason) { news_ |= bit(reason); }
  /// The arm does what it is asked: whatever it refuses next is news.
  void obey() { standing_ = 0; }

  /// Calls `visit(ArmWarning)` for each that has come since forgetNews().
  template <class Visit>
  void forEachNew(const Visit& visit) const {
    for (unsigned i = 0; news_ >> i != 0; ++i) {
      if ((news_ >> i & 1) != 0) visit(static_cast<ArmWarning>(i));
    }
  }
  void forgetNews() { news_ = 0; }

 private:
  static std::uint32_t bit(ArmWarning reason) { return 1U << static_cast<unsigned>(reason); }

  std::uint32_t standing_ = 0, news_ = 0;
};

}  // namespace robots
