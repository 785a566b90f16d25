#pragma once
// A contract that derives from one of another header: the model of what is generated for those.

#include <suture/annotate.h>

#include "reference/arm_like.h"

namespace reference {

/// An arm with a gripper.
class SUTURE_INTERFACE() GripperArm : public ArmLike {
 public:
  /// Closes to this width; answers the width that it could reach.
  SUTURE_COMMAND() virtual double close(SUTURE_FIELD(unit("m")) double width) = 0;
  SUTURE_COMMAND() virtual double opening() const = 0;
  /// Lets go at once.
  SUTURE_COMMAND(direct()) virtual void release() = 0;
  SUTURE_COMMAND(concurrent()) virtual bool fits(SUTURE_FIELD(unit("m")) double width) const = 0;
  SUTURE_EVENT() suture::EventOf<double> gripped;
};

}  // namespace reference
