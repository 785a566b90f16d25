#pragma once
// The contract of the hand that a simulated master's gripper is in.

#include <suture/annotate.h>

namespace robots {

/// Simulated drives of a master provide it as "Hand", for real ones have a surgeon's. Commands run
/// in the drives' own thread before its next cycle.
class SUTURE_INTERFACE() GripperHand {
 public:
  virtual ~GripperHand() = default;

  /// The fingers press the handles to this angle, newest wins: there it stays until another one.
  /// The gripper follows with the lag of the drives, and no further than its stops.
  SUTURE_COMMAND(latest(), ttl(100ms))
  virtual void squeeze(SUTURE_FIELD(unit("rad")) double angle) = 0;
};

}  // namespace robots
