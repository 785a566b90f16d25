#include "force_feedback/fixture_resistance.h"

#include "parameters/parameter_check.h"

namespace robots {

FixtureResistance::FixtureResistance(const FixtureResistanceModel& model)
    : damping_(model.damping), port_(model.port) {
  ParameterCheck("resistance of fixtures")
      .isNotNegative("damping in N.s/m", damping_)
      .isFinite("damping in N.s/m", damping_);
}

}  // namespace robots
