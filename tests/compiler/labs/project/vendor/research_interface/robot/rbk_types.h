// This has the shape of libfranka's research_interface/robot/rbk_types.h: what its robot sends,
// packed.
#pragma once

#include <array>
#include <cstdint>

namespace research_interface {
namespace robot {

#pragma pack(push, 1)

enum class MotionGeneratorMode : uint8_t { kIdle, kJointPosition, kJointVelocity, kNone };

struct RobotState {
  uint64_t message_id;
  std::array<double, 16> O_T_EE;
  double m_ee;
  std::array<double, 7> q;
  std::array<bool, 41> errors;
  MotionGeneratorMode motion_generator_mode;
  double control_command_success_rate;
};

template <typename T>
struct CommandHeader {
  T command;
  uint32_t command_id;
  uint32_t size;
};

enum class Command : uint8_t { kConnect, kMove, kStopMove, kAutomaticErrorRecovery };

struct MoveRequest {
  struct Deviation {
    double translation;
    double rotation;
    double elbow;
  };

  CommandHeader<Command> header;
  bool immediate;
  std::array<Deviation, 2> maximum_deviations;
};

#pragma pack(pop)

}  // namespace robot
}  // namespace research_interface
