#pragma once
// A client outside of any component, as a script or a window is. It belongs to one thread, which
// hears events only while it listens.

#include <suture/manager/handle.h>
#include <suture/manager/manager.h>

#include <optional>
#include <string>

#include "05_events/gripper.suture.h"

namespace gripping {

class Listener {
 public:
  /// Subscribes to all events of the gripper, and prints what it hears.
  Listener(suture::Manager& manager, const std::string& name);

  suture::Required<Gripper>& gripper() { return gripper_; }
  /// What it has heard last of the jaws; none: nothing so far.
  std::optional<Jaws> jaws() const { return jaws_; }

  /// Sleeps until something arrives, and hears it. Throws std::runtime_error if nothing arrives for
  /// two seconds.
  void listen();

 private:
  const std::string name_;
  std::optional<Jaws> jaws_;
  suture::Handle<Gripper> gripper_;
};

}  // namespace gripping
