#pragma once
// What a teleoperation knows of the surgeon at its console.

#include <suture/component/required.h>

#include "pedals/foot_pedals.suture.h"
#include "pedals/operator_presence.suture.h"

namespace robots {

/// A member of the component that owns both interfaces, declared after them; belongs to the same
/// thread.
class OperatorWatch {
 public:
  /// What is older than `maxAge` is not known.
  OperatorWatch(suture::Required<FootPedals>& pedals, suture::Required<OperatorPresence>& presence,
                suture::Duration maxAge)
      : pedals_(pedals), presence_(presence), maxAge_(maxAge) {}

  /// The surgeon is there, and no pedal takes the masters from their slaves. A console without
  /// pedals, or without anything that tells of presence, is not asked for it; one that is silent,
  /// or not there yet, says no.
  bool teleoperates() {
    const auto pedals = pedals_.pedals();
    const bool isFree = isFresh(pedals) && !pedals->clutch && !pedals->camera;
    if (!pedals_.isAbsent() && !isFree) return false;
    const auto presence = presence_.presence();
    return presence_.isAbsent() || (isFresh(presence) && presence->present);
  }

 private:
  template <class Value>
  bool isFresh(const suture::Sample<Value>& sample) const {
    return sample && suture::now() - sample->stamp <= maxAge_;
  }

  suture::Required<FootPedals>& pedals_;
  suture::Required<OperatorPresence>& presence_;
  const suture::Duration maxAge_;
};

}  // namespace robots
