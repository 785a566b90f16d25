#pragma once
// This is what an interface says of its coordinate frames.

#include <suture/base/frames.h>

#include <string>

namespace suture {

/// Belongs to one interface. The thread that puts the system together sets it before that interface
/// is connected, and any thread reads it.
class DeclaredFrames {
 public:
  const Frames& get() const { return frames_; }

  /// Adds to what has been declared: a component may say one frame and the deployment the other.
  /// Throws SetupError if `frames` names another frame than has been declared for `interface`.
  void add(const Frames& frames, const std::string& interface);

 private:
  Frames frames_;
};

}  // namespace suture
