#pragma once
// This is the contract: two commands, and two kinds of event.

#include <suture/annotate.h>

#include <cstdint>

namespace gripping {

enum class SUTURE_TYPE() Jaws : std::uint8_t { Open, Closing, Holding };

class SUTURE_INTERFACE() Gripper {
 public:
  virtual ~Gripper() = default;

  /// Begins to close the jaws.
  SUTURE_COMMAND() virtual void grasp() = 0;
  /// Opens the jaws. Returns true if they held something.
  SUTURE_COMMAND() virtual bool release() = 0;

  /// Reports a state: a client that subscribes late receives the last one at once.
  SUTURE_EVENT(latched()) suture::EventOf<Jaws> jaws_changed;
  /// Reports something that happens. Each touch counts, so up to 16 wait for a busy subscriber.
  SUTURE_EVENT(queue(16)) SUTURE_FIELD(unit("N")) suture::EventOf<double> touched;
};

}  // namespace gripping
