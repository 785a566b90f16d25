#include "registration/registration_table.h"

#include <suture/base/errors.h>

#include <string>

#include "arm_control/goals.h"

namespace robots {
namespace {

/// What follows takes the transpose of a rotation for its inverse.
void requireRigid(const char* name, const Eigen::Isometry3d& frame) {
  if (isRigid(frame)) return;
  throw suture::SetupError("registering the frame \"" + std::string(name) + "\"",
                           "its rotation is not orthonormal to 1e-6, or mirrors",
                           "write a rotation matrix with all its digits");
}

}  // namespace

RegistrationTable::RegistrationTable(const SceneFrames& frames) : frames_(frames) {
  requireRigid("left_base", frames.left_base);
  requireRigid("right_base", frames.right_base);
  requireRigid("camera", frames.camera);
}

}  // namespace robots
