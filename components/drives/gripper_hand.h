#pragma once
// This is the contract of the hand that holds a simulated master's gripper.

#include <suture/annotate.h>

namespace robots {

/// Simulated drives of a master provide this as "Hand", because real ones have a surgeon's.
/// Commands run in the drives' own thread before its next cycle.
class SUTURE_INTERFACE() GripperHand {
 public:
  virtual ~GripperHand() = default;

  /// Makes the fingers press the handles to this angle, newest wins. It stays there until another
  /// one comes. The gripper follows with the lag of the drives, and no further than its stops.
  SUTURE_COMMAND(latest(), ttl(100ms))
  virtual void squeeze(SUTURE_FIELD(unit("rad")) double angle) = 0;
};

}  // namespace robots
