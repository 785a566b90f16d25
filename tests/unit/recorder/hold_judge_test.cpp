// This is the judge of a break: the tests say what it accepts, and each fault that it has to find.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "recorder/hold_judge.h"

namespace robots {
namespace {

using namespace std::chrono_literals;

const suture::Time kBroken{10s}, kMended{11s};

/// It says how far an arm moves or turns in the cycle at a time.
using Steps = std::function<double(suture::Time)>;

/// Returns three seconds of an arm that moves by `step` in the cycle at that time.
std::vector<ArmRow> armThatMoves(const Steps& step) {
  std::vector<ArmRow> rows;
  double x = 0;
  for (suture::Time time{9s}; time < suture::Time{12s}; time += 1ms) {
    x += step(time);
    rows.emplace_back();
    rows.back().stamp = time;
    rows.back().setpoint.translation().x() = x;
  }
  return rows;
}

/// It moves by 0.1 mm a cycle, but for the time between.
std::vector<ArmRow> armThatHolds(suture::Time from, suture::Time to) {
  return armThatMoves([=](suture::Time time) { return time >= from && time < to ? 0 : 1e-4; });
}

/// It holds while it is cut off, and in the cycles of `length` that begin 10 ms after that it makes
/// steps of `jump`.
Steps jumps(double jump, suture::Duration length, double usual) {
  return [=](suture::Time time) {
    const suture::Time begin = kMended + 10ms;
    if (time >= begin && time < begin + length) return jump;
    return time >= kBroken && time < begin ? 0 : usual;
  };
}

/// Returns the one thing that is wrong with how the arm held.
std::string onlyViolation(const std::vector<ArmRow>& rows, const HoldBounds& bounds = {}) {
  const auto found = violations(judgeHold(rows, kBroken, kMended), bounds);
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? "" : found.front();
}

TEST(HoldJudge, AcceptsAnArmThatHoldsSoon) {
  const HoldJudgement judgement =
      judgeHold(armThatHolds(kBroken + 20ms, kMended + 300ms), kBroken, kMended);
  EXPECT_NEAR(judgement.held_after, 0.019, 1e-9);
  ASSERT_TRUE(judgement.resumed_after);
  EXPECT_NEAR(*judgement.resumed_after, 0.3, 1e-9);
  EXPECT_EQ(judgement.jumps.largest, 0);
  EXPECT_TRUE(violations(judgement).empty());
}

TEST(HoldJudge, AcceptsACutOffRecorderToo) {
  std::vector<ArmRow> rows = armThatHolds(kBroken, kMended);
  std::erase_if(rows,
                [](const ArmRow& row) { return row.stamp >= kBroken && row.stamp < kMended; });
  EXPECT_TRUE(violations(judgeHold(rows, kBroken, kMended)).empty());
}

TEST(HoldJudge, FindsAnArmThatWentOn) {
  EXPECT_EQ(onlyViolation(armThatHolds(kMended, kMended)),
            "it moved until 999 ms after that, at most 500 ms allowed");
}

TEST(HoldJudge, FindsAnArmThatStopsLate) {
  const auto rows = armThatHolds(kBroken + 450ms, kMended);
  EXPECT_TRUE(violations(judgeHold(rows, kBroken, kMended)).empty());
  EXPECT_EQ(onlyViolation(rows, {.held_after = 0.08}),
            "it moved until 449 ms after that, at most 80 ms allowed");
}

TEST(HoldJudge, FindsAnArmThatStoodStillBefore) {
  const auto rows = armThatMoves(
      [](suture::Time time) { return time < kBroken - 600ms || time >= kMended ? 1e-4 : 0; });
  EXPECT_EQ(onlyViolation(rows), "it stood still before, so nobody can tell whether it held");
}

TEST(HoldJudge, FindsAnArmThatNeverMovedAgain) {
  EXPECT_EQ(onlyViolation(armThatHolds(kBroken, suture::Time{12s})), "it never moved again");
}

TEST(HoldJudge, SaysWhyAFaultedArmRests) {
  auto rows = armThatHolds(kBroken, kMended);  // its set-point follows what moves the joints
  for (ArmRow& row : rows) row.enabled = row.stamp < kBroken + 250ms;
  EXPECT_EQ(onlyViolation(rows),
            "it never moved again, and was not enabled at the end: an arm whose drives fell silent "
            "stays in FAULT until a person enables or disables it");
}

TEST(HoldJudge, FindsAnArmThatCatchesUp) {
  const auto rows = armThatMoves(jumps(0.10025, 1ms, 1e-4));
  EXPECT_EQ(onlyViolation(rows), "its set-point jumped by 100.0 mm, at most 3.0 mm allowed");
}

TEST(HoldJudge, FindsAnArmThatJumpsInPieces) {
  const auto rows = armThatMoves(jumps(0.0029, 20ms, 1e-4));
  EXPECT_EQ(onlyViolation(rows), "its set-point jumped by 53.0 mm, at most 3.0 mm allowed");
}

/// Returns an arm that stands still, but turns by `step` in the cycle at that time.
std::vector<ArmRow> armThatTurns(const Steps& step) {
  std::vector<ArmRow> rows = armThatMoves([](suture::Time) { return 0; });
  double angle = 0;
  for (ArmRow& row : rows) {
    angle += step(row.stamp);
    row.setpoint.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  return rows;
}

TEST(HoldJudge, FindsAnArmThatWentOnTurning) {
  const auto rows = armThatTurns([](suture::Time) { return 1e-3; });
  EXPECT_EQ(onlyViolation(rows), "it moved until 999 ms after that, at most 500 ms allowed");
}

TEST(HoldJudge, FindsAnArmThatTurnsAtOnce) {
  const auto rows = armThatTurns(jumps(0.35, 1ms, 1e-3));
  EXPECT_EQ(onlyViolation(rows),
            "its set-point turned by 19.9 deg at once, at most 3.0 deg allowed");
}

TEST(HoldJudge, FindsAnArmThatTurnsInPieces) {
  const auto rows = armThatTurns(jumps(0.05, 20ms, 1e-3));
  EXPECT_EQ(onlyViolation(rows),
            "its set-point turned by 53.9 deg at once, at most 3.0 deg allowed");
}

}  // namespace
}  // namespace robots
