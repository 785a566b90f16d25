#include "registration/registration_table.h"

#include <suture/base/errors.h>

#include <chrono>
#include <string>

#include "robot_types/rigid_pose.h"

namespace robots {
namespace {

constexpr suture::Duration kRegistrationPeriod = std::chrono::milliseconds(10);
constexpr unsigned kRowsOfFrames = 128;

void makeRigid(const char* name, Eigen::Isometry3d& frame) {
  if (isRigid(frame)) {
    frame = exact(frame);
    return;
  }
  throw suture::SetupError("registering the frame \"" + std::string(name) + "\"",
                           "its rotation is not orthonormal to 1e-6, or mirrors",
                           "Write a rotation matrix with all its digits");
}

}  // namespace

RegistrationTable::RegistrationTable(const SceneFrames& frames)
    : PeriodicTask({.period = kRegistrationPeriod}), frames_(frames) {
  makeRigid("left_base", frames_.left_base);
  makeRigid("right_base", frames_.right_base);
  makeRigid("camera", frames_.camera);
  makeRigid("left_master", frames_.left_master);
  makeRigid("right_master", frames_.right_master);
  makeRigid("display", frames_.display);
  registration_.keepState({.rows = kRowsOfFrames});
}

void RegistrationTable::set_camera(const Eigen::Isometry3d& camera) {
  if (isRigid(camera)) {
    frames_.camera = exact(camera);
    return;
  }
  messages_.warning(
      "set_camera: the rotation is not orthonormal to 1e-6; the camera stays registered as it was");
}

}  // namespace robots
