#include <suture/testing/test_clock.h>

#include <chrono>
#include <vector>

#include "experiment/experiment.h"
#include "experiment/room/operating_room.h"
#include "surgeon/operator.h"

namespace experiment {

using namespace std::chrono_literals;

Result run(const Trial& trial) {
  suture::TestClock clock;
  robots::Operator surgeon(operatorOf(trial));
  OperatingRoom room(trial, {.seed = trial.seed});
  room.seat(surgeon);
  room.connectOperator();
  room.start();
  std::vector<Moment> moments;
  if (!clock.until([&] { return room.guiding(); }, 30s)) return judge(moments);
  Tracking tracking;
  while (moments.size() < momentsIn(kLength)) {
    moments.push_back(tracking.momentOf(room.truth()));
    clock.advance(1ms);
  }
  return judge(moments);
}

}  // namespace experiment
