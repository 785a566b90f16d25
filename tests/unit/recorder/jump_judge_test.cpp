// This is the judge of a whole run: the tests say what it accepts, however late anybody was, and
// each jump that it has to find.

#include "recorder/jump_judge.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Sentences = std::vector<std::string>;

constexpr auto kArmCycle = 1ms;
constexpr double kHandSpeed = 0.08;  // m/s, of the demo's slaves

double alongHand(suture::Time time) {
  return kHandSpeed * std::chrono::duration<double>(time - suture::Time{}).count();
}

/// Returns ten seconds of an arm that trails its hand by 1 ms, changed by `change` in each cycle.
std::vector<ArmRow> armThatFollows(const std::function<void(ArmRow&)>& change) {
  std::vector<ArmRow> rows;
  for (suture::Time time{1s}; time < suture::Time{11s}; time += kArmCycle) {
    ArmRow row;
    row.stamp = time;
    row.goal_stamp = time - kArmCycle;
    row.setpoint.translation().x() = alongHand(row.goal_stamp);
    row.measured.translation().x() = alongHand(row.goal_stamp - 1ms);
    change(row);
    rows.push_back(row);
  }
  return rows;
}

bool isIn(const ArmRow& row, suture::Time begin, suture::Duration length) {
  return row.stamp >= begin && row.stamp < begin + length;
}

Sentences violationsOf(const std::vector<ArmRow>& rows) {
  JumpJudge judge;
  judge.add(rows);
  return violations(judge.judgement());
}

TEST(JumpJudge, AcceptsAnArmThatFollowsAHand) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow&) {})), Sentences{});
}

TEST(JumpJudge, FindsAJumpOfEightyMilliseconds) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              if (!isIn(row, suture::Time{5s}, 80ms)) return;
              row.setpoint.translation().y() = row.measured.translation().y() = 0.02;
            })),
            Sentences{"its set-point jumped by 19.8 mm, at most 3.0 mm allowed"});
}

TEST(JumpJudge, FindsDrivesThatLeaveTheirSetpoints) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              if (isIn(row, suture::Time{5s}, 80ms)) row.measured.translation().y() = 0.02;
            })),
            Sentences{"it was 20.0 mm from the path of its set-points, at most 5.0 mm allowed"});
}

TEST(JumpJudge, FindsASlaveThatTurnsAtOnce) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              if (!isIn(row, suture::Time{5s}, 80ms)) return;
              row.setpoint.linear() =
                  Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
            })),
            Sentences{"its set-point turned by 11.3 deg at once, at most 3.0 deg allowed"});
}

/// The goals of a stream that comes again are no reason for a jump after a rest.
TEST(JumpJudge, FindsASlaveThatCatchesUp) {
  const suture::Time begin{5s};
  EXPECT_EQ(violationsOf(armThatFollows([&](ArmRow& row) {
              if (!isIn(row, begin, 1s)) return;
              row.goal_stamp = begin;
              row.setpoint.translation().x() = alongHand(begin);
              row.measured.translation().x() = alongHand(begin);
            })),
            Sentences{"its set-point jumped by 73.7 mm, at most 3.0 mm allowed"});
}

TEST(JumpJudge, ExcusesAnArmThatIsNotEnabled) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              row.enabled = row.stamp < suture::Time{4s} || row.stamp >= suture::Time{6s};
              const bool lifted = isIn(row, suture::Time{5s}, 6s);
              if (lifted) row.setpoint.translation().y() = row.measured.translation().y() = 0.02;
            })),
            Sentences{});
}

TEST(JumpJudge, FindsAJumpWhenEnabled) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              row.enabled = row.stamp >= suture::Time{4s};
              if (row.enabled) row.setpoint.translation().y() = 0.004;
              if (row.enabled) row.measured.translation().y() = 0.004;
            })),
            Sentences{"its set-point jumped by 3.8 mm, at most 3.0 mm allowed"});
}

/// Its set-point rests, and then goes on from the hand's next pose, all within the 20 ms for which
/// data count.
TEST(JumpJudge, ExcusesATeleoperationThatIsLate) {
  EXPECT_EQ(violationsOf(armThatFollows([](ArmRow& row) {
              row.goal_stamp -= (row.goal_stamp - suture::Time{}) % 20ms;
              row.setpoint.translation().x() = alongHand(row.goal_stamp);
              row.measured.translation().x() = alongHand(row.goal_stamp - 3ms);
            })),
            Sentences{});
}

/// A recorder reads only the newest row, so one that is late misses those before.
TEST(JumpJudge, ExcusesARecorderThatIsLate) {
  auto rows = armThatFollows([](ArmRow&) {});
  rows.erase(rows.begin() + 1000, rows.begin() + 1200);
  for (int i = 3000; i > 0; i -= 50) rows.erase(rows.begin() + i, rows.begin() + i + 45);
  EXPECT_EQ(violationsOf(rows), Sentences{});
}

// The whole machine stood still for a second, so the hand did not go on either.
TEST(JumpJudge, ExcusesAMachineThatStoodStill) {
  std::vector<ArmRow> rows = armThatFollows([](ArmRow&) {});
  for (ArmRow& row : rows) {
    if (row.stamp < suture::Time{5s}) continue;
    row.stamp += 1s;
    row.goal_stamp += 1s;
  }
  EXPECT_EQ(violationsOf(rows), Sentences{});
}

}  // namespace
}  // namespace robots::test
