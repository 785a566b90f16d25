#pragma once
// What an interface says of its coordinate frames.

#include <suture/base/frames.h>

#include <string>

namespace suture {

/// Belongs to one interface. It is set before that interface is connected, by the thread that puts
/// the system together, and read by any.
class DeclaredFrames {
 public:
  const Frames& get() const { return frames_; }

  /// Adds to what has been declared: its component says one frame perhaps, and the deployment the
  /// other. Throws SetupError if `frames` names another frame than has been declared for
  /// `interface`.
  void add(const Frames& frames, const std::string& interface);

 private:
  Frames frames_;
};

}  // namespace suture
