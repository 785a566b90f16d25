// This has the shape of libfranka's franka/control_types.h: commands that no constructor makes of
// nothing.
#pragma once

#include <array>
#include <initializer_list>

namespace franka {

enum class ControllerMode { kJointImpedance, kCartesianImpedance };
enum class RealtimeConfig { kEnforce, kIgnore };

struct Finishable {
  bool motion_finished = false;
};

class Torques : public Finishable {
 public:
  Torques(const std::array<double, 7>& torques) noexcept : tau_J(torques) {}
  Torques(std::initializer_list<double> torques) {
    std::size_t i = 0;
    for (double torque : torques) tau_J.at(i++) = torque;
  }

  std::array<double, 7> tau_J{};
};

class CartesianPose : public Finishable {
 public:
  CartesianPose(const std::array<double, 16>& cartesian_pose) noexcept : O_T_EE(cartesian_pose) {}
  CartesianPose(const std::array<double, 16>& cartesian_pose,
                const std::array<double, 2>& elbow_) noexcept
      : O_T_EE(cartesian_pose), elbow(elbow_) {}

  std::array<double, 16> O_T_EE{};
  std::array<double, 2> elbow{};

  bool hasElbow() const noexcept { return elbow[1] != 0; }
};

inline Torques MotionFinished(Torques command) noexcept {
  command.motion_finished = true;
  return command;
}

}  // namespace franka
