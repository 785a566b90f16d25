#pragma once
// This is a client outside of any component, such as a script or a window. It belongs to one
// thread, which receives events only while it listens.

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
  /// Returns the last state of the jaws that it has received; none if there was none so far.
  std::optional<Jaws> jaws() const { return jaws_; }

  /// Sleeps until something arrives, and handles it. Throws std::runtime_error if nothing arrives
  /// for two seconds.
  void listen();

 private:
  const std::string name_;
  std::optional<Jaws> jaws_;
  suture::Handle<Gripper> gripper_;
};

}  // namespace gripping
