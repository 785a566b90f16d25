#pragma once
// This is what a teleoperation knows of the surgeon at its console.

#include <suture/component/required.h>

#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"
#include "timing/recent.h"

namespace robots {

/// Belongs to the thread of the component that owns both interfaces, which has it as a member
/// declared after them.
class OperatorWatch {
 public:
  /// Data of which the row or the stamp is older than `maxAge` count as unknown, and so do those of
  /// the future.
  OperatorWatch(suture::Required<FootPedals>& pedals, suture::Required<OperatorPresence>& presence,
                suture::Duration maxAge)
      : pedals_(pedals), presence_(presence), maxAge_(maxAge) {}

  /// Returns true if the surgeon is there and no pedal takes the masters from their slaves. If
  /// pedals or presence are not connected, they are not needed; if they are silent, or not there
  /// yet, this returns false.
  bool teleoperates() {
    const auto pedals = pedals_.pedals();
    const bool isFree = isFresh(pedals) && !pedals->clutch && !pedals->camera;
    return (pedals_.isAbsent() || isFree) && isPresent();
  }
  /// Returns true if the surgeon is there, whatever the pedals say. What was said of presence above
  /// counts here too.
  bool isPresent() {
    const auto presence = presence_.presence();
    return presence_.isAbsent() || (isFresh(presence) && presence->present);
  }

 private:
  template <class Value>
  bool isFresh(const suture::Sample<Value>& sample) const {
    return sample && sample.age() <= maxAge_ && isRecent(sample->stamp, maxAge_);
  }

  suture::Required<FootPedals>& pedals_;
  suture::Required<OperatorPresence>& presence_;
  const suture::Duration maxAge_;
};

}  // namespace robots
