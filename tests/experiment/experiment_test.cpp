// These are two points of the grid: the operator places the knot at once, and does not over half a
// second.

#include "experiment/experiment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "experiment/table.h"
#include "experiment/trial.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;

Trial freeHands(suture::Duration roundTrip) {
  return {.link = {.roundTrip = roundTrip}, .fixtures = false};
}

std::size_t columnsOf(const std::string& line) {
  return static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

TEST(Experiment, TheKnotIsPlacedWithoutADelay) {
  const Trial trial = freeHands(0ms);
  const Result result = run(trial);
  EXPECT_EQ(result.outcome, Outcome::Placed);
  EXPECT_LT(result.error, 0.001);
  EXPECT_LT(result.time.value_or(kLength), 10);
  const std::string line = row(trial, result);
  EXPECT_EQ(line.rfind("0,0,0,off,2,1,0.", 0), 0u) << line;
  EXPECT_EQ(columnsOf(line), columnsOf(header()));
  EXPECT_TRUE(line.ends_with(",placed")) << line;
}

TEST(Experiment, TheKnotIsNotPlacedBriefly) {
  const Trial trial = freeHands(500ms);
  const Result result = run(trial);
  EXPECT_FALSE(result.time);
  EXPECT_GT(result.error, 0.002);
  EXPECT_EQ(columnsOf(row(trial, result)), columnsOf(header()));
}

TEST(Experiment, EqualTrialsHaveEqualResults) {
  const Trial trial{.link = {.roundTrip = 100ms, .jitter = 0.1, .loss = 0.01}, .seed = 3};
  const Result result = run(trial);
  EXPECT_EQ(result, run(trial));
  Trial other = trial;
  other.seed = 4;
  EXPECT_FALSE(result == run(other));
}

}  // namespace
}  // namespace experiment
