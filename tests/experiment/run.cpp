#include <suture/testing/test_clock.h>

#include <chrono>
#include <optional>
#include <vector>

#include "experiment/experiment.h"
#include "experiment/operating_room.h"
#include "integration/teleoperation/knot_scene.h"
#include "surgeon/operator.h"
#include "teleop/follow_law.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;
using Pair = OperatingRoom::Pair;
using robots::FollowLaw;

/// How far each slave is from where its master asks it to be now, from where both were when the
/// guide last began.
class Tracking {
 public:
  explicit Tracking(const OperatingRoom& room) : room_(room) {}

  Moment now() {
    Moment moment{.error = room_.knot() - robots::test::kKnotTarget, .guided = room_.guiding()};
    if (!moment.guided) {
      left_.reset();
      right_.reset();
      return moment;
    }
    moment.left = errorOf(left_, room_.left());
    moment.right = errorOf(right_, room_.right());
    return moment;
  }

 private:
  static double errorOf(std::optional<FollowLaw>& law, const Pair& pair) {
    if (!law) {
      law.emplace(pair.master, pair.setpoint,
                  robots::FollowSettings{.scale = OperatingRoom::kScale});
    }
    return (law->follow(pair.master).translation() - pair.slave.translation()).norm();
  }

  const OperatingRoom& room_;
  std::optional<FollowLaw> left_, right_;
};

}  // namespace

Result run(const Trial& trial) {
  suture::TestClock clock;
  robots::Operator surgeon(
      {.target = robots::test::kKnotTarget, .scale = OperatingRoom::kScale, .seed = trial.seed});
  OperatingRoom room(trial, {.seed = trial.seed});
  room.seat(surgeon);
  room.connectOperator();
  room.start();
  std::vector<Moment> moments;
  if (!clock.until([&] { return room.guiding(); }, 30s)) return judge(moments);
  Tracking tracking(room);
  while (moments.size() < momentsIn(kLength)) {
    moments.push_back(tracking.now());
    clock.advance(1ms);
  }
  return judge(moments);
}

}  // namespace experiment
