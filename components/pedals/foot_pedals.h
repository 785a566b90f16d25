#pragma once
// The contract of a console's foot pedals.

#include <suture/annotate.h>
#include <suture/base/time.h>

namespace robots {

/// What the feet do. It counts for as long as it is fresh: whoever does not hear of the pedals any
/// more must take them for pressed.
struct SUTURE_TYPE() PedalState {
  /// Masters move without their slaves.
  bool clutch = false;
  /// Masters move the camera instead of their slaves.
  bool camera = false;
  /// Energy is applied to the tissue.
  bool coagulation = false;
  /// The cycle that they were looked at in.
  suture::Time stamp;
};

/// The names are the da Vinci Research Kit's.
class SUTURE_INTERFACE() FootPedals {
 public:
  virtual ~FootPedals() = default;

  SUTURE_COMMAND() virtual PedalState pedals() const = 0;

  /// Pressed or released, and as it is now to whoever connects.
  SUTURE_EVENT(latched()) suture::EventOf<bool> clutch;
  SUTURE_EVENT(latched()) suture::EventOf<bool> camera;
  SUTURE_EVENT(latched()) suture::EventOf<bool> coagulation;
};

}  // namespace robots
