// This is the longest delay of the picture with which an operator closes a stable loop: a quarter
// of a turn at the frequency of crossover, less the operator's own delay and the loop's.

#include "integration/operator/limit.h"

#include <gtest/gtest.h>

#include <chrono>

#include "integration/operator/desk.h"
#include "integration/operator/lag_probe.h"
#include "surgeon/operator.h"
#include "timing/seconds.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using suture::pass;

double measuredLag(suture::Duration delay) {
  LagProbe probe(Scene::kScale);
  Desk desk;
  desk.seat(probe, delay);
  desk.manager.start();
  pass(500ms);  // the first picture has come, however late
  probe.begin();
  pass(LagProbe::kTakes);
  desk.manager.stop();
  return probe.lag();
}

/// Tells if the error of the knot dies out.
bool isStable(suture::Duration delay) {
  Desk desk;
  // The way is so short that no bound is reached.
  desk.seatOperator({.target = {0.002, 0, 0}, .remnant = 0, .tremor = 0}, delay);
  return diesOut([&] { return desk.knot().x() - 0.002; });
}

TEST(Operator, SeesThePictureAfterItsDelay) {
  const double own = measuredLag(0ms);
  RecordProperty("loop_ms", std::to_string(1000 * own));
  EXPECT_GT(own, inSeconds(Scene::kPeriod) / 2);
  EXPECT_LT(own, inSeconds(Scene::kPeriod) / 2 + 0.01);
  EXPECT_NEAR(measuredLag(200ms) - own, 0.2, 0.002);
}

TEST(Operator, ClosesAStableLoopBelowItsLimit) {
  const double limit = limitByFormula({}, measuredLag(0ms));
  const suture::Duration stable = longestStable(isStable, 150ms, 450ms, 10ms);
  RecordProperty("limit_ms", std::to_string(1000 * limit));
  RecordProperty("stable_ms", std::to_string(1000 * inSeconds(stable)));
  EXPECT_NEAR(inSeconds(stable) / limit, 1, 0.1);
}

}  // namespace
}  // namespace robots::test
