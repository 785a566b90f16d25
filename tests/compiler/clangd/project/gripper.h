#pragma once
#include <suture/annotate.h>

namespace edited {

/// How far the fingers are apart.
struct SUTURE_TYPE() Opening {
  SUTURE_FIELD(unit("m"), range(0, 0.1)) double width = 0;
};

/// Opens and closes a hand.
class SUTURE_INTERFACE() Gripper {
 public:
  virtual ~Gripper() = default;

  /// Moves the fingers there.
  SUTURE_COMMAND(latest(), ttl(20ms)) virtual void move(const Opening& goal) = 0;
  SUTURE_COMMAND() virtual Opening opening() const = 0;

  SUTURE_EVENT(latched()) suture::EventOf<Opening> arrived;
};

}  // namespace edited
