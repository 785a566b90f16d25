#pragma once
// An online trajectory generator of ruckig, for seven joints. Each instance has a name here.

#include <suture/annotate.h>

#include <ruckig/output_parameter.hpp>

#include <limits>

namespace lab {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Input7 = ruckig::InputParameter<7>;
using Output7 = ruckig::OutputParameter<7>;

SUTURE_EXTERNAL_TYPE(ruckig::ControlInterface);
SUTURE_EXTERNAL_TYPE(ruckig::Synchronization);
SUTURE_EXTERNAL_TYPE(ruckig::DurationDiscretization);
SUTURE_EXTERNAL_TYPE(ruckig::Result);
SUTURE_EXTERNAL_TYPE(ruckig::BrakeProfile);
SUTURE_EXTERNAL_TYPE(ruckig::Profile::ReachedLimits);
SUTURE_EXTERNAL_TYPE(ruckig::Profile::Direction);
SUTURE_EXTERNAL_TYPE(ruckig::Profile::ControlSigns);
SUTURE_EXTERNAL_TYPE(ruckig::Profile);
SUTURE_EXTERNAL_TYPE(Input7, all(), member(max_velocity, range(0, kInfinity)),
                     member(max_acceleration, range(0, kInfinity)),
                     member(max_jerk, range(0, kInfinity)),
                     member(intermediate_positions, capacity(3)),
                     member(per_section_max_velocity, capacity(4)),
                     member(per_section_minimum_duration, capacity(4)));
SUTURE_EXTERNAL_TYPE(Output7, all(), member(trajectory, skip()));

/// Plans a motion while it runs.
class SUTURE_INTERFACE() Planner {
 public:
  virtual ~Planner() = default;
  SUTURE_COMMAND() virtual ruckig::Result plan(const Input7& input) = 0;
  SUTURE_COMMAND() virtual const Output7& output() const = 0;
  SUTURE_EVENT(queue(4)) suture::EventOf<ruckig::Profile, ruckig::Result> ended;
};

}  // namespace lab
