#pragma once
// An arm keeps its warnings here until it emits them at the end of a cycle.

#include <cstdint>
#include <string_view>

#include "arm/arm_warning.h"

namespace robots {

/// Returns what an arm says about it, for people.
std::string_view textOf(ArmWarning reason);

/// Returns true if it is about one joint, whose name stands before the text.
constexpr bool isOfJoint(ArmWarning reason) {
  return reason == ArmWarning::FollowingError || reason == ArmWarning::EncoderJump ||
         reason == ArmWarning::OverCurrent;
}

/// One thread; never allocates. Collects the warnings that are emitted at the end of a cycle.
class Warnings {
 public:
  /// Adds a warning, once until the arm obeys again.
  void warn(ArmWarning reason) {
    if ((standing_ & bit(reason)) == 0) news_ |= bit(reason);
    standing_ |= bit(reason);
  }
  /// Adds a warning each time.
  void tell(ArmWarning reason) { news_ |= bit(reason); }
  /// Says that the arm does what it is asked, so its next refusal is reported again.
  void obey() { standing_ = 0; }

  /// Calls `visit(ArmWarning)` for each that was added since forgetNews().
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
