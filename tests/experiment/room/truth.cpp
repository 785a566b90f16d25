#include "experiment/room/truth.h"

#include "experiment/trial.h"
#include "integration/teleoperation/scene/knot_scene.h"

namespace experiment {
namespace {

double errorOf(std::optional<robots::FollowLaw>& law, const Pair& pair) {
  if (!law) law.emplace(pair.master, pair.setpoint, robots::FollowSettings{.scale = kScale});
  return (law->follow(pair.master).translation() - pair.slave.translation()).norm();
}

}  // namespace

Moment Tracking::momentOf(const Truth& truth) {
  Moment moment{.error = truth.knot - robots::test::kKnotTarget, .guided = truth.guided};
  if (!moment.guided) {
    left_.reset();
    right_.reset();
    return moment;
  }
  moment.left = errorOf(left_, truth.left);
  moment.right = errorOf(right_, truth.right);
  return moment;
}

}  // namespace experiment
