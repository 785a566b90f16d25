#pragma once
// This is the contract of a console's foot pedals.

#include <suture/annotate.h>
#include <suture/base/time.h>

namespace robots {

/// Says what the feet do. It counts only as long as it is fresh: a client that does not receive it
/// any more must assume that all pedals are pressed.
struct SUTURE_TYPE() PedalState {
  /// If it is true, masters move without their slaves.
  bool clutch = false;
  /// If it is true, masters move the camera instead of their slaves. The components here simulate
  /// no camera that masters move: slaves only hold.
  bool camera = false;
  /// If it is true, energy is applied to the tissue.
  bool coagulation = false;
  /// The stamp is that of the cycle in which they were looked at.
  suture::Time stamp;
};

/// The names are the da Vinci Research Kit's.
class SUTURE_INTERFACE() FootPedals {
 public:
  virtual ~FootPedals() = default;

  SUTURE_COMMAND() virtual PedalState pedals() const = 0;

  /// Reports each press and release, and the present state to a client that connects.
  SUTURE_EVENT(latched()) suture::EventOf<bool> clutch;
  SUTURE_EVENT(latched()) suture::EventOf<bool> camera;
  SUTURE_EVENT(latched()) suture::EventOf<bool> coagulation;
};

}  // namespace robots
