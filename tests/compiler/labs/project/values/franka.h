#pragma once
// This is the state of an arm of libfranka, with what its hooks carry.

#include "labs/franka.h"
#include "members.h"

namespace invented {

using franka::RobotMode, franka::VacuumGripperDeviceStatus;

inline void fill(RobotMode& value, Random& random, Bounds&) {
  pick(value, random,
       {RobotMode::kOther, RobotMode::kIdle, RobotMode::kMove, RobotMode::kGuiding,
        RobotMode::kReflex, RobotMode::kUserStopped, RobotMode::kAutomaticErrorRecovery});
}
inline void fill(VacuumGripperDeviceStatus& value, Random& random, Bounds&) {
  using enum VacuumGripperDeviceStatus;
  pick(value, random, {kGreen, kYellow, kOrange, kRed});
}
inline void fill(franka::Errors& value, Random& random, Bounds& bounds) {
  std::array<bool, 41> flags;
  fill(flags, random, bounds);
  value = flags;
}
inline bool equal(const franka::Errors& a, const franka::Errors& b, Tag tag) {
  using Hook = suture::Wire<franka::Errors>;
  return equal(Hook::to(a), Hook::to(b), tag);
}
inline void fill(franka::Duration& value, Random& random, Bounds&) {
  value = franka::Duration(random());
}
inline bool equal(const franka::Duration& a, const franka::Duration& b, Tag) { return a == b; }

auto fields(As<franka::Torques> auto& v, Tag) { return list(v.tau_J); }
auto fields(As<franka::RobotCommand> auto& v, Tag) { return list(v.torques); }
auto fields(As<franka::Record> auto& v, Tag) { return list(v.state, v.command); }
auto fields(As<franka::VacuumGripperState> auto& v, Tag) {
  return list(v.in_control_range, v.part_detached, v.part_present, v.device_status, v.actual_power,
              v.vacuum, v.time);
}
auto fields(As<franka::RobotState> auto& v, Tag) {
  return list(v.O_T_EE, v.O_T_EE_d, v.F_T_EE, v.F_T_NE, v.NE_T_EE, v.EE_T_K, ranged(v.m_ee, 0, 20),
              v.I_ee, v.F_x_Cee, v.m_load, v.I_load, v.F_x_Cload, v.m_total, v.I_total,
              v.F_x_Ctotal, v.elbow, v.elbow_d, v.elbow_c, v.delbow_c, v.ddelbow_c, v.tau_J,
              v.tau_J_d, v.dtau_J, v.q, v.q_d, v.dq, v.dq_d, v.ddq_d, v.joint_contact,
              v.cartesian_contact, v.joint_collision, v.cartesian_collision, v.tau_ext_hat_filtered,
              v.O_F_ext_hat_K, v.K_F_ext_hat_K, v.O_dP_EE_d, v.O_ddP_O, v.O_T_EE_c, v.O_dP_EE_c,
              v.O_ddP_EE_c, v.theta, v.dtheta, v.current_errors, v.last_motion_errors,
              v.control_command_success_rate, v.robot_mode, v.robot_mode, v.time);
}

}  // namespace invented
