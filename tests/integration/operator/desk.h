#pragma once
// This is an operator at two masters, in one process.

#include <suture/manager/manager.h>

#include <Eigen/Core>
#include <chrono>
#include <memory>

#include "integration/operator/scene.h"
#include "integration/teleoperation/scene/scripted_arm.h"
#include "registration/registration_table.h"
#include "support/pass.h"
#include "surgeon/operator.h"

namespace robots::test {

/// Seats a task, which requires "Left", "Right" and "Vision", and sees the picture late by what
/// `delay` adds.
struct Desk {
  explicit Desk(const SceneFrames& frames = {}) : registration(frames) {
    manager.add("LeftMaster", left);
    manager.add("RightMaster", right);
    manager.add("Scene", scene);
    manager.add("Registration", registration);
    manager.connect("Scene/Left", "LeftMaster/Arm");
    manager.connect("Scene/Right", "RightMaster/Arm");
  }
  ~Desk() { manager.stop(); }

  /// Seats `task`, which must live as long as this, as "Operator".
  void seat(suture::Task& task, suture::Duration delay) {
    manager.add("Operator", task);
    manager.connect("Operator/Left", "LeftMaster/Arm");
    manager.connect("Operator/Right", "RightMaster/Arm");
    manager.connect("Operator/Vision", "Scene/Vision",
                    {.patience = std::chrono::seconds(1), .delay = {.answers = delay}});
  }
  void seatOperator(const OperatorParameters& parameters, suture::Duration delay = {}) {
    surgeon = std::make_unique<Operator>(parameters);
    seat(*surgeon, delay);
    manager.connect("Operator/Guidance", "Scene/Guidance");
    manager.connect("Operator/Registration", "Registration/Registration");
    manager.start();
  }
  /// Makes what the registration tells take so much longer from now on.
  void registerLate(suture::Duration delay) {
    manager.disconnect("Operator/Registration");
    manager.connect("Operator/Registration", "Registration/Registration",
                    {.patience = std::chrono::seconds(1), .delay = {.answers = delay}});
  }
  Eigen::Vector3d knot() const {
    return Scene::kScale / 2 * (left.pose().translation() + right.pose().translation());
  }

  ScriptedArm left, right;
  Scene scene;
  RegistrationTable registration;
  std::unique_ptr<Operator> surgeon;
  suture::Manager manager{"desk"};
};

}  // namespace robots::test
