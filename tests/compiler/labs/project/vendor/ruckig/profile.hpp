// The shape of ruckig's profile.hpp and brake.hpp: enums inside of a class, arrays without
// initialisers, static members.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include <ruckig/utils.hpp>

namespace ruckig {

struct Bound {
  double min, max;
  double t_min, t_max;
};

class BrakeProfile {
  static constexpr double eps{2.2e-14};

  void acceleration_brake(double v0, double a0, double vMax, double vMin, double aMax, double aMin,
                          double jMax);

 public:
  double duration{0.0};
  std::array<double, 2> t, j, a, v, p;

  void finalize(double& ps, double& vs, double& as);
};

class Profile {
  static constexpr double v_eps{1e-12};

 public:
  enum class ReachedLimits { ACC0_ACC1_VEL, VEL, ACC0, ACC1, ACC0_ACC1, ACC0_VEL, ACC1_VEL, NONE };
  enum class Direction { UP, DOWN };
  enum class ControlSigns { UDDU, UDUD };

  static constexpr double p_precision{1e-8};
  static constexpr double t_max{1e12};

  std::array<double, 7> t, t_sum, j;
  std::array<double, 8> a, v, p;

  BrakeProfile brake, accel;
  double pf, vf, af;

  ReachedLimits limits;
  Direction direction;
  ControlSigns control_signs;

  template <ControlSigns control_signs_, ReachedLimits limits_>
  bool check_for_velocity(double jf, double aMax, double aMin);
};

}  // namespace ruckig
