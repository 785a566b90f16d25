#pragma once
// The contract for which the files beside this one were written by hand: what suturec's output must
// look like, and what the runtime's own tests run on.

#include <suture/annotate.h>

#include <cstdint>
#include <string>

#include "reference/arm_types.h"

namespace reference {

class SUTURE_INTERFACE() ArmLike {
 public:
  virtual ~ArmLike() = default;
  /// Follows a stream of poses.
  SUTURE_COMMAND(latest(), ttl(500ms)) virtual void servo_cp(const PoseStamped& goal) = 0;
  SUTURE_COMMAND(latest()) virtual void servo_jp(const JointState& goal) = 0;
  SUTURE_COMMAND(queue(4)) virtual void hold() = 0;
  SUTURE_COMMAND() virtual void set_mode(Mode mode) = 0;
  SUTURE_COMMAND() virtual PoseStamped measured_cp() const = 0;
  SUTURE_COMMAND() virtual const JointState& measured_js() const = 0;
  SUTURE_COMMAND() virtual double distance(const PoseStamped& to) const = 0;
  /// Moves along a line; answers whether it can.
  SUTURE_COMMAND(deadline(200ms))
  virtual bool move(const PoseStamped& goal, SUTURE_FIELD(range(0, 1)) double speed,
                    SUTURE_FIELD(capacity(15)) const std::string& reason) = 0;
  /// Forgets what it was told; answers how much that was.
  SUTURE_COMMAND() virtual std::uint32_t reset() = 0;
  SUTURE_COMMAND(queue(2)) virtual void limit(double speed, Mode mode) = 0;
  /// Folds the arm.
  SUTURE_COMMAND(optional()) virtual void park() {}
  SUTURE_EVENT(latched(), name("mode")) suture::EventOf<Mode> mode_event;
  SUTURE_EVENT(queue(4)) suture::EventOf<PoseStamped> arrived;
  SUTURE_EVENT() suture::EventOf<> stopped;
  /// Where it is and how fast.
  SUTURE_EVENT() suture::EventOf<PoseStamped, double> moved;
};

}  // namespace reference
