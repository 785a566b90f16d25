#pragma once
// These say where arms and camera stand, and where the knot shall be, in tests that place one.

#include <Eigen/Core>

#include "registration/registration.h"

namespace robots::test {

/// The knot shall come here in the scene, m.
inline const Eigen::Vector3d kKnotTarget{0.004, -0.003, -0.152};

/// Both slaves stand 10 cm from each other; the camera looks down at the tissue between them, and
/// the surgeon down into the display, so that masters move as their slaves do.
inline SceneFrames knotScene() {
  SceneFrames frames;
  frames.left_base.translation().x() = -0.05;
  frames.right_base.translation().x() = 0.05;
  frames.camera.linear().diagonal() << 1, -1, -1;
  frames.camera.translation().z() = -0.04;
  frames.display.linear() = frames.camera.linear();
  return frames;
}

}  // namespace robots::test
