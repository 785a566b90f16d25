// The judge accepts a slave that follows, and sees each way of not following.
//
// Master and slave are made here, not by the components: a hand path sampled at 1 kHz, a slave on
// its own cycle times that gets the law's goals late by a transport delay and trails them by the
// time constant.

#include "recorder/judge.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

#include "surgeon/hand_path.h"

namespace robots::test {
namespace {

constexpr double kTimeConstant = 0.01;
constexpr double kScale = 0.4;

suture::Time at(double seconds) {
  return suture::fromNanoseconds(1'000'000'000 + static_cast<std::int64_t>(seconds * 1e9));
}

Eigen::Isometry3d poseOf(const Eigen::Vector3d& p, double angle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = p;
  pose.linear() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(3, 1, 2).normalized()).toRotationMatrix();
  return pose;
}

struct Faults {
  double sign = 1;        // -1: the slave moves the wrong way
  double extraLag = 0;    // s, undeclared
  bool frozen = false;    // measures the same for ever
  bool rotates = true;    // follows the orientation
  double missedRows = 0;  // share of cycles the recorders lose
  double delay = 0;       // s, of the goals beyond 1 to 2 ms: no fault, since their stamps tell it
  int cyclesUntilGoals = 0;  // that pass until the drives act on a goal: no fault, if declared
};

struct Recorded {
  std::vector<ArmRow> master, slave;
  std::vector<FollowAnchors> followed;
};

Recorded makeRun(const Faults& faults, double frequency = 0.3, double duration = 10) {
  Recorded run;
  const HandPath hand(poseOf({0, -0.4, 0}, 0.3),
                      {.amplitude = 0.1, .turn = 0.3, .frequency = frequency, .ramp = 1.0});
  const Eigen::Isometry3d slave0 = poseOf({0, 0, -0.1}, -1.2);
  const Eigen::Isometry3d master0 = hand.at(0);
  run.followed.push_back({at(0), master0, slave0, kScale, 1});

  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (double t = 0; t < duration; t += 0.001) {
    if (uniform(random) >= faults.missedRows) run.master.push_back({at(t), hand.at(t), at(t), {}});
  }
  // Goals arrive 1 to 2 ms after their stamp, on cycles 0.4 ms out of phase.
  Eigen::Vector3d p = slave0.translation();
  Eigen::Quaterniond q(slave0.linear());
  std::deque<std::pair<Eigen::Vector3d, Eigen::Quaterniond>> targets(
      static_cast<std::size_t>(1 + faults.cyclesUntilGoals), {p, q});
  const double share = 1 - std::exp(-0.001 / (kTimeConstant + faults.extraLag));
  for (double t = 0.0024 + faults.delay; t < duration; t += 0.001) {
    p += share * (targets.front().first - p);
    q = q.slerp(share, targets.front().second);
    targets.pop_front();
    const double goalTime = std::floor((t - 0.001 - faults.delay) * 1000) / 1000;
    const Eigen::Isometry3d master = hand.at(goalTime);
    const Eigen::Matrix3d turned = master.linear() * master0.linear().transpose() * slave0.linear();
    targets.emplace_back(
        slave0.translation() +
            faults.sign * kScale * (master.translation() - master0.translation()),
        faults.rotates ? Eigen::Quaterniond(turned) : Eigen::Quaterniond(slave0.linear()));
    ArmRow row{at(t), Eigen::Isometry3d::Identity(), at(goalTime), {}};
    row.measured.translation() = faults.frozen ? slave0.translation() : p;
    row.measured.linear() = faults.frozen ? slave0.linear() : q.toRotationMatrix();
    if (uniform(random) >= faults.missedRows) run.slave.push_back(row);
  }
  return run;
}

Judgement judged(const Recorded& run) {
  return judge(run.master, run.followed, run.slave, {kTimeConstant});
}

TEST(Judge, FindsNoErrorInALawfulSlave) {
  const Judgement judgement = judged(makeRun({}));
  EXPECT_GT(judgement.compared, 9900u);
  EXPECT_EQ(judgement.unmatched, 0u);
  EXPECT_LT(judgement.position.max, 1e-9);
  EXPECT_LT(judgement.orientation.max, 1e-7);
  EXPECT_GT(judgement.travel, 0.03);
  EXPECT_TRUE(violations(judgement).empty());
}

TEST(Judge, ASlaveWithoutLagMeetsItsGoal) {
  const Recorded prompt = makeRun({.extraLag = -kTimeConstant});
  const Judgement judgement = judge(prompt.master, prompt.followed, prompt.slave, {});
  EXPECT_GT(judgement.compared, 9900u);
  EXPECT_LT(judgement.position.max, 1e-9);
  EXPECT_NEAR(judgement.speed_times_latency, judgement.equal_time.mean,
              0.1 * judgement.equal_time.mean);
  const Recorded late = makeRun({}, 1.2);
  EXPECT_FALSE(violations(judge(late.master, late.followed, late.slave, {})).empty());
}

TEST(Judge, DrivesActInTheirNextCycle) {
  const Recorded run = makeRun({.cyclesUntilGoals = 1}, 1.2);
  EXPECT_GT(judged(run).position.p99, 1e-4) << "nobody declared it";
  const Judgement judgement =
      judge(run.master, run.followed, run.slave, {.time_constant = kTimeConstant, .delay = 0.001});
  EXPECT_LT(judgement.position.max, 1e-9);
  EXPECT_NEAR(judgement.equal_time.mean, judgement.speed_times_latency,
              0.02 * judgement.equal_time.mean);
}

TEST(Judge, ToleratesRecordersThatMissCycles) {
  const Judgement judgement = judged(makeRun({.missedRows = 0.1}));
  EXPECT_LT(judgement.position.p99, 1e-4);
  EXPECT_TRUE(violations(judgement).empty());
}

TEST(Judge, SeesASwappedSign) {
  const Judgement judgement = judged(makeRun({.sign = -1}));
  EXPECT_GT(judgement.position.p99, 0.03);
  EXPECT_EQ(violations(judgement).size(), 1u);
}

TEST(Judge, SeesAFrozenSlave) {
  const auto found = violations(judged(makeRun({.frozen = true})));
  ASSERT_EQ(found.size(), 3u) << "position, orientation and travel";
  EXPECT_EQ(found[2], "the slave travelled 0.0 mm, at least 30.0 mm required");
}

TEST(Judge, SeesAnOrientationThatDoesNotFollow) {
  const Judgement judgement = judged(makeRun({.rotates = false}));
  EXPECT_LT(judgement.position.p99, 1e-9);
  EXPECT_EQ(violations(judgement).size(), 1u);
}

// An undeclared lag shows as speed times lag, whatever is its cause.
TEST(Judge, SeesFiveMillisecondsOfUndeclaredLag) {
  const Judgement slow = judged(makeRun({.extraLag = 0.005}));
  EXPECT_GT(slow.position.p99, 0.0003);
  const Judgement fast = judged(makeRun({.extraLag = 0.005}, 1.2));
  EXPECT_GT(fast.position.p99, 0.001);
  EXPECT_FALSE(violations(fast).empty());
}

TEST(Judge, ExplainsTheErrorOfALateSlave) {
  double before = 0;
  for (const double delay : {0.0, 0.05, 0.2}) {
    const Judgement judgement = judged(makeRun({.delay = delay}));
    EXPECT_LT(judgement.position.max, 1e-9) << "the goals that it got, it followed";
    EXPECT_NEAR(judgement.equal_time.mean, judgement.speed_times_latency,
                0.1 * judgement.speed_times_latency);
    EXPECT_GT(judgement.equal_time.mean, before) << "with " << delay << " s";
    before = judgement.equal_time.mean;
  }
  EXPECT_GT(before, 0.005);
}

constexpr const char* kHalf =
    "the slave followed for 50 % of the time, at least 90 % required: not from 5.0 to 10.0 s after "
    "it began";

using Change = std::function<void(ArmRow& row, const ArmRow& last)>;

/// Returns what is wrong with a run in which `change` has been made to each row from `begin` on.
std::vector<std::string> violationsAfter(suture::Time begin, const Change& change,
                                         const Duty& duty = {}) {
  Recorded run = makeRun({});
  ArmRow last;
  for (ArmRow& row : run.slave) {
    if (row.stamp < begin) {
      last = row;
    } else {
      change(row, last);
    }
  }
  Judge judge({kTimeConstant});
  judge.addMaster(run.master);
  judge.addFollowed(run.followed);
  judge.addSlave(run.slave);
  return violations(judge.finish(duty));
}

// A slave is thought to follow for 50 ms after its last goal.
std::vector<std::string> violationsWithoutGoals(const Duty& duty = {}) {
  return violationsAfter(
      at(4.95),
      [](ArmRow& row, const ArmRow& last) {
        row.goal_stamp = last.goal_stamp;
        row.measured = last.measured;
      },
      duty);
}

std::vector<std::string> violationsIfDisabled(const Duty& duty = {}) {
  return violationsAfter(
      at(5), [](ArmRow& row, const ArmRow&) { row.enabled = false; }, duty);
}

TEST(Judge, SeesASlaveThatGetsNoGoals) {
  EXPECT_EQ(violationsWithoutGoals(), std::vector<std::string>{kHalf});
}

TEST(Judge, SeesASlaveThatIsDisabled) {
  EXPECT_EQ(violationsIfDisabled(), std::vector<std::string>{kHalf});
}

TEST(Judge, SeesATooShortRecording) {
  Recorded run = makeRun({});
  std::erase_if(run.slave, [](const ArmRow& row) { return row.stamp > at(5); });
  EXPECT_EQ(violations(judged(run)), std::vector<std::string>{kHalf});
}

TEST(Judge, AsksOnlyForDueFollowing) {
  EXPECT_TRUE(violationsWithoutGoals({.end = at(5.2)}).empty());
  EXPECT_TRUE(violationsWithoutGoals({.excused = {{at(5), at(7)}, {at(6), at(10)}}}).empty());
  EXPECT_TRUE(violationsWithoutGoals({.excused = {{at(4), at(7)}}}).empty()) << "it recovers";
  const auto found = violationsIfDisabled({.excused = {{at(4), at(6)}}});
  ASSERT_EQ(found.size(), 1u) << "but it has not recovered for too long";
  EXPECT_EQ(found[0],
            "the slave followed for 80 % of the time, at least 90 % required: not from 9.0 to 10.0 "
            "s after it began");
}

TEST(Judge, TheClutchAsksForNoFollowing) {
  const std::vector<ClutchNews> news{{false, at(1)}, {true, at(5)},  {true, at(6)},
                                     {false, at(7)}, {false, at(8)}, {true, at(9)}};
  const std::vector<Span> spans = clutched(news, at(10));
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].begin, at(5));
  EXPECT_EQ(spans[0].end, at(7));
  EXPECT_EQ(spans[1].begin, at(9));
  EXPECT_EQ(spans[1].end, at(10));
}

TEST(Judge, AMomentWithoutDataIsNoRelease) {
  const std::vector<Span> spans =
      clutched({{true, at(5)}, {false, at(6)}, {true, at(6.2)}, {false, at(8)}}, at(10));
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].begin, at(5));
  EXPECT_EQ(spans[0].end, at(8));
}

// The slave stands 5 mm off, without power, from 4 s to 5 s; then it follows again.
TEST(Judge, ADisabledSlaveIsNotJudged) {
  Recorded run = makeRun({});
  for (ArmRow& row : run.slave) {
    if (row.stamp < at(4) || row.stamp >= at(5)) continue;
    row.measured.translation().x() += 0.005;
    row.goal_stamp = row.stamp;
  }
  FollowAnchors again = run.followed.front();
  again.master_stamp = at(5);
  again.entry = 2;
  run.followed.push_back(again);
  EXPECT_GT(judged(run).position.p99, 0.004) << "nobody says that it is disabled";
  // The slave is enabled 2 ms after the stamp of what it then follows.
  for (ArmRow& row : run.slave) row.enabled = row.stamp < at(4) || row.stamp >= at(5.002);
  const Judgement judgement = judged(run);
  EXPECT_LT(judgement.position.max, 1e-6);
  EXPECT_GT(judgement.compared, 8900u);
  EXPECT_LT(judgement.compared, 9000u);
  EXPECT_GT(judgement.travel, 0.03);
}

TEST(Judge, EachEntrysAnchorsHold) {
  Recorded run = makeRun({});
  // Another entry has a slave set-point 5 mm off from 5 s on: the recorded slave does not go there.
  FollowAnchors again = run.followed.front();
  again.master_stamp = at(5);
  again.slave_setpoint.translation().x() += 0.005;
  again.entry = 2;
  run.followed.push_back(again);
  const Judgement judgement = judged(run);
  EXPECT_NEAR(judgement.position.max, 0.005, 1e-4);
  EXPECT_LT(judgement.position.p50, 0.005);
}

TEST(Judge, SaysWhenThereIsNothingToCompare) {
  const Recorded run = makeRun({});
  EXPECT_EQ(violations(judge(run.master, {}, run.slave, {kTimeConstant})).front(),
            "the slave never followed");
  const std::vector<ArmRow> half(run.master.begin(), run.master.begin() + 5000);
  const Judgement judgement = judge(half, run.followed, run.slave, {kTimeConstant});
  EXPECT_NEAR(static_cast<double>(judgement.unmatched), 5000, 10);
  EXPECT_FALSE(violations(judgement).empty());
}

// The demo judges so: it writes pieces of recordings at different speeds.
TEST(Judge, APiecemealRunIsJudgedTheSame) {
  const Recorded run = makeRun({.extraLag = 0.005, .missedRows = 0.1});
  Judge judge({kTimeConstant});
  double worst = 0;
  for (std::size_t i = 0; i < run.master.size(); i += 250) {
    const auto piece = [i](const std::vector<ArmRow>& rows, std::size_t lead) {
      const auto at = [&](std::size_t k) { return rows.begin() + std::min(k, rows.size()); };
      return std::vector<ArmRow>(at(i == 0 ? 0 : i + lead), at(i + 250 + lead));
    };
    judge.addSlave(piece(run.slave, 100));
    judge.addMaster(piece(run.master, 0));
    if (i == 0) judge.addFollowed(run.followed);
    judge.advance();
    if (const auto recent = judge.recentPosition()) worst = std::max(worst, recent->max);
  }
  const Judgement whole = judged(run), pieces = judge.finish();
  EXPECT_EQ(pieces.compared, whole.compared);
  EXPECT_EQ(pieces.unmatched, whole.unmatched);
  EXPECT_EQ(pieces.travel, whole.travel);
  EXPECT_EQ(pieces.position.p99, whole.position.p99);
  EXPECT_EQ(pieces.orientation.max, whole.orientation.max);
  EXPECT_GT(worst, 0.9 * whole.position.max) << "the pieces told of it on the way";
}

}  // namespace
}  // namespace robots::test
