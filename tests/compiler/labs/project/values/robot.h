#pragma once
// Packed structs, whose members are filled where they lie; no reference to one is taken.

#include <cstddef>
#include <cstring>

#include "labs/robot.h"
#include "members.h"

namespace invented {

using research_interface::robot::Command, research_interface::robot::MotionGeneratorMode;
using research_interface::robot::MoveRequest;
using ControlState = research_interface::robot::RobotState;

inline void fill(Command& value, Random& random, Bounds&) {
  using enum Command;
  pick(value, random, {kConnect, kMove, kStopMove, kAutomaticErrorRecovery});
}
inline void fill(MotionGeneratorMode& value, Random& random, Bounds&) {
  using enum MotionGeneratorMode;
  pick(value, random, {kIdle, kJointPosition, kJointVelocity, kNone});
}

/// Fills the member of that type that lies `offset` bytes behind the beginning.
template <class Member, class T>
void fillAt(T& value, std::size_t offset, Random& random) {
  Member member;
  fillMember(member, random);
  std::memcpy(reinterpret_cast<std::byte*>(&value) + offset, &member, sizeof member);
}

inline void fill(ControlState& value, Random& random, Bounds&) {
  fillAt<std::uint64_t>(value, offsetof(ControlState, message_id), random);
  fillAt<std::array<double, 16>>(value, offsetof(ControlState, O_T_EE), random);
  fillAt<double>(value, offsetof(ControlState, m_ee), random);
  fillAt<std::array<double, 7>>(value, offsetof(ControlState, q), random);
  fillAt<std::array<bool, 41>>(value, offsetof(ControlState, errors), random);
  fillAt<MotionGeneratorMode>(value, offsetof(ControlState, motion_generator_mode), random);
  fillAt<double>(value, offsetof(ControlState, control_command_success_rate), random);
}
inline void fill(MoveRequest& value, Random& random, Bounds&) {
  constexpr std::size_t header = offsetof(MoveRequest, header);
  fillAt<Command>(value, header + offsetof(lab::robot::CommandHeader, command), random);
  fillAt<std::uint32_t>(value, header + offsetof(lab::robot::CommandHeader, command_id), random);
  fillAt<std::uint32_t>(value, header + offsetof(lab::robot::CommandHeader, size), random);
  fillAt<bool>(value, offsetof(MoveRequest, immediate), random);
  fillAt<std::array<double, 6>>(value, offsetof(MoveRequest, maximum_deviations), random);
}
/// Each byte belongs to a member.
inline bool equal(const ControlState& a, const ControlState& b, Tag) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
inline bool equal(const MoveRequest& a, const MoveRequest& b, Tag) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace invented
