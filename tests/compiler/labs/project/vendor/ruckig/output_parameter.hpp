// The shape of ruckig's trajectory.hpp and output_parameter.hpp.
#pragma once

#include <array>
#include <vector>

#include <ruckig/input_parameter.hpp>
#include <ruckig/profile.hpp>

namespace ruckig {

template <size_t DOFs, template <class, size_t> class CustomVector = StandardVector>
class Trajectory {
  template <class T>
  using Vector = CustomVector<T, DOFs>;

  std::vector<Vector<Profile>> profiles;
  double duration{0.0};
  std::vector<double> cumulative_times;
  Vector<double> independent_min_durations;
  Vector<Bound> position_extrema;
  size_t continue_calculation_counter{0};

  void resize(size_t max_number_of_waypoints) {
    profiles.resize(max_number_of_waypoints + 1);
    cumulative_times.resize(max_number_of_waypoints + 1);
  }

 public:
  size_t degrees_of_freedom;

  template <size_t D = DOFs, typename std::enable_if<(D >= 1), int>::type = 0>
  Trajectory() : degrees_of_freedom(DOFs) {
    resize(0);
  }

  double get_duration() const { return duration; }
  std::vector<double> get_intermediate_durations() const { return cumulative_times; }
};

template <size_t DOFs, template <class, size_t> class CustomVector = StandardVector>
class OutputParameter {
  template <class T>
  using Vector = CustomVector<T, DOFs>;

 public:
  size_t degrees_of_freedom;

  Trajectory<DOFs, CustomVector> trajectory;

  Vector<double> new_position, new_velocity, new_acceleration, new_jerk;

  double time{0.0};
  size_t new_section{0};
  bool did_section_change{false};
  bool new_calculation{false};
  bool was_calculation_interrupted{false};
  double calculation_duration;

  template <size_t D = DOFs, typename std::enable_if<(D >= 1), int>::type = 0>
  OutputParameter() : degrees_of_freedom(DOFs) {}

  void pass_to_input(InputParameter<DOFs, CustomVector>& input) const {
    input.current_position = new_position;
    input.current_velocity = new_velocity;
    input.current_acceleration = new_acceleration;
  }
};

}  // namespace ruckig
