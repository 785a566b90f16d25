#include "registration/registration_table.h"

#include <suture/base/errors.h>

#include <chrono>
#include <string>

#include "arm_control/goals.h"

namespace robots {
namespace {

constexpr suture::Duration kRegistrationPeriod = std::chrono::milliseconds(10);
constexpr unsigned kRowsOfFrames = 128;

/// What follows takes the transpose of a rotation for its inverse.
void requireRigid(const char* name, const Eigen::Isometry3d& frame) {
  if (isRigid(frame)) return;
  throw suture::SetupError("registering the frame \"" + std::string(name) + "\"",
                           "its rotation is not orthonormal to 1e-6, or mirrors",
                           "write a rotation matrix with all its digits");
}

}  // namespace

RegistrationTable::RegistrationTable(const SceneFrames& frames)
    : PeriodicTask({.period = kRegistrationPeriod}), frames_(frames) {
  requireRigid("left_base", frames.left_base);
  requireRigid("right_base", frames.right_base);
  requireRigid("camera", frames.camera);
  requireRigid("left_master", frames.left_master);
  requireRigid("right_master", frames.right_master);
  requireRigid("display", frames.display);
  registration_.keepState({.rows = kRowsOfFrames});
}

void RegistrationTable::set_camera(const Eigen::Isometry3d& camera) {
  if (isRigid(camera)) {
    frames_.camera = camera;
    return;
  }
  messages_.warning(
      "set_camera: the rotation is not orthonormal to 1e-6; the camera stays registered as it was");
}

}  // namespace robots
