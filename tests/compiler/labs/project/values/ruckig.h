#pragma once
// These are Ruckig's instances for seven joints: infinite limits, optionals, enums inside of a
// class.

#include "labs/ruckig.h"
#include "members.h"

namespace invented {

using ruckig::ControlInterface, ruckig::Synchronization, ruckig::DurationDiscretization;
using ruckig::Profile;

inline void fill(ControlInterface& value, Random& random, Bounds&) {
  pick(value, random, {ControlInterface::Position, ControlInterface::Velocity});
}
inline void fill(Synchronization& value, Random& random, Bounds&) {
  using enum Synchronization;
  pick(value, random, {Time, TimeIfNecessary, Phase, None});
}
inline void fill(DurationDiscretization& value, Random& random, Bounds&) {
  using enum DurationDiscretization;
  pick(value, random, {Continuous, Discrete});
}
inline void fill(Profile::ReachedLimits& value, Random& random, Bounds&) {
  using enum Profile::ReachedLimits;
  pick(value, random, {ACC0_ACC1_VEL, VEL, ACC0, ACC1, ACC0_ACC1, ACC0_VEL, ACC1_VEL, NONE});
}
inline void fill(Profile::Direction& value, Random& random, Bounds&) {
  pick(value, random, {Profile::Direction::UP, Profile::Direction::DOWN});
}
inline void fill(Profile::ControlSigns& value, Random& random, Bounds&) {
  pick(value, random, {Profile::ControlSigns::UDDU, Profile::ControlSigns::UDUD});
}

auto fields(As<ruckig::BrakeProfile> auto& v, Tag) {
  return list(v.duration, v.t, v.j, v.a, v.v, v.p);
}
auto fields(As<Profile> auto& v, Tag) {
  return list(v.t, v.t_sum, v.j, v.a, v.v, v.p, v.brake, v.accel, v.pf, v.vf, v.af, v.limits,
              v.direction, v.control_signs);
}
auto fields(As<lab::Input7> auto& v, Tag) {
  return list(v.degrees_of_freedom, v.control_interface, v.synchronization,
              v.duration_discretization, v.current_position, v.current_velocity,
              v.current_acceleration, v.target_position, v.target_velocity, v.target_acceleration,
              ranged(v.max_velocity, 0, kInfinity), ranged(v.max_acceleration, 0, kInfinity),
              ranged(v.max_jerk, 0, kInfinity), v.min_velocity, v.min_acceleration,
              bounded(v.intermediate_positions, 3), bounded(v.per_section_max_velocity, 4),
              v.max_position, v.min_position, v.enabled, v.per_dof_control_interface,
              v.per_dof_synchronization, v.minimum_duration,
              bounded(v.per_section_minimum_duration, 4), v.interrupt_calculation_duration);
}
auto fields(As<lab::Output7> auto& v, Tag) {
  return list(v.degrees_of_freedom, v.new_position, v.new_velocity, v.new_acceleration, v.new_jerk,
              v.time, v.new_section, v.did_section_change, v.new_calculation,
              v.was_calculation_interrupted, v.calculation_duration);
}

}  // namespace invented
