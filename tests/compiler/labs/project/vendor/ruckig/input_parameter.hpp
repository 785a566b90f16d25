// The shape of ruckig's input_parameter.hpp: limits are infinite until somebody lowers them.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <ruckig/utils.hpp>

namespace ruckig {

enum class ControlInterface { Position, Velocity };

enum class Synchronization { Time, TimeIfNecessary, Phase, None };

enum class DurationDiscretization { Continuous, Discrete };

template <size_t DOFs, template <class, size_t> class CustomVector = StandardVector>
class InputParameter {
  template <class T>
  using Vector = CustomVector<T, DOFs>;

  inline static double v_at_a_zero(double v0, double a0, double j) {
    return v0 + (a0 * a0) / (2 * j);
  }

  void initialize() {
    for (size_t dof = 0; dof < degrees_of_freedom; ++dof) {
      current_velocity[dof] = 0.0;
      current_acceleration[dof] = 0.0;
      target_velocity[dof] = 0.0;
      target_acceleration[dof] = 0.0;
      max_acceleration[dof] = std::numeric_limits<double>::infinity();
      max_jerk[dof] = std::numeric_limits<double>::infinity();
      enabled[dof] = true;
    }
  }

  void resize(size_t dofs) {
    current_position.resize(dofs);
    current_velocity.resize(dofs);
    current_acceleration.resize(dofs);
    target_position.resize(dofs);
    target_velocity.resize(dofs);
    target_acceleration.resize(dofs);
    max_velocity.resize(dofs);
    max_acceleration.resize(dofs);
    max_jerk.resize(dofs);
    enabled.resize(dofs);
  }

 public:
  size_t degrees_of_freedom;

  ControlInterface control_interface{ControlInterface::Position};
  Synchronization synchronization{Synchronization::Time};
  DurationDiscretization duration_discretization{DurationDiscretization::Continuous};

  Vector<double> current_position, current_velocity, current_acceleration;
  Vector<double> target_position, target_velocity, target_acceleration;
  Vector<double> max_velocity, max_acceleration, max_jerk;
  std::optional<Vector<double>> min_velocity, min_acceleration;

  std::vector<Vector<double>> intermediate_positions;
  std::optional<std::vector<Vector<double>>> per_section_max_velocity;
  std::optional<Vector<double>> max_position, min_position;

  Vector<bool> enabled;
  std::optional<Vector<ControlInterface>> per_dof_control_interface;
  std::optional<Vector<Synchronization>> per_dof_synchronization;
  std::optional<double> minimum_duration;
  std::optional<std::vector<double>> per_section_minimum_duration;
  std::optional<double> interrupt_calculation_duration;

  template <size_t D = DOFs, typename std::enable_if<(D >= 1), int>::type = 0>
  InputParameter() : degrees_of_freedom(DOFs) {
    initialize();
  }
  template <size_t D = DOFs, typename std::enable_if<(D == 0), int>::type = 0>
  InputParameter(size_t dofs) : degrees_of_freedom(dofs) {
    resize(dofs);
    initialize();
  }

  bool validate(bool check_current_state_within_limits = false) const;
  bool operator!=(const InputParameter<DOFs, CustomVector>& rhs) const;
  std::string to_string() const;
};

}  // namespace ruckig
