// One scripted surgeon has a slave go the same way, whatever is between them.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "integration/teleoperation/scene/two_workstations.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "timing/seconds.h"

namespace robots::test {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

/// Holds what master and slave did since the surgeon set out.
class RecordedRun {
 public:
  RecordedRun(const suture::Lane& lane, suture::Duration delay) {
    TwoWorkstations stations(lane, delay);
    suture::pass(kLength + 2s);
    stations.stop();
    master_ = stations.master().arm;
    slave_ = stations.slave().arm;
    setOut_ = setOutOf(master_);
  }

  /// Returns the way until so long after, m in the base frame of each.
  Vector3d master(suture::Duration after) const { return way(master_, after); }
  Vector3d slave(suture::Duration after) const { return way(slave_, after); }
  /// Returns how fast the slave went at most, m/s.
  double speed() const {
    double most = 0;
    for (suture::Duration after{}; after < kLength; after += 10ms) {
      most = std::max(most, (slave(after + 10ms) - slave(after)).norm() / 0.01);
    }
    return most;
  }
  /// s, in the mean: how old the master's data were that the slave acted on.
  double latency() const {
    double sum = 0;
    std::size_t count = 0;
    for (const ArmRow& row : slave_) {
      if (row.stamp < setOut_ + 1s) continue;
      sum += secondsBetween(row.goal_stamp, row.stamp);
      ++count;
    }
    return sum / static_cast<double>(count);
  }

  static constexpr suture::Duration kLength = 2500ms;

 private:
  /// Returns the stamp of the surgeon's first goal, which is where the master was: the master is in
  /// motion ever since.
  static suture::Time setOutOf(const std::vector<ArmRow>& rows) {
    constexpr double kStill = 1e-12;  // m
    for (std::size_t i = rows.size(); i-- > 1;) {
      const Vector3d step = rows[i].setpoint.translation() - rows[i - 1].setpoint.translation();
      if (step.norm() < kStill) return rows[i].goal_stamp;
    }
    throw std::runtime_error("the master was never still");
  }
  Vector3d way(const std::vector<ArmRow>& rows, suture::Duration after) const {
    return placeAt(rows, setOut_ + after) - placeAt(rows, setOut_);
  }
  static Vector3d placeAt(const std::vector<ArmRow>& rows, suture::Time time) {
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), time,
                         [](suture::Time wanted, const ArmRow& row) { return wanted < row.stamp; });
    if (after == rows.begin() || after == rows.end()) {
      throw std::runtime_error("the recording does not go so far");
    }
    const ArmRow& before = *(after - 1);
    const double share =
        secondsBetween(before.stamp, time) / secondsBetween(before.stamp, after->stamp);
    return before.measured.translation() * (1 - share) + after->measured.translation() * share;
  }

  std::vector<ArmRow> master_, slave_;
  suture::Time setOut_;
};

class Trajectory : public testing::TestWithParam<std::tuple<suture::Lane, suture::Duration>> {};

std::string nameOfWiring(const testing::TestParamInfo<Trajectory::ParamType>& one) {
  const auto& [lane, delay] = one.param;
  return toString(lane) + "_" + std::to_string(delay / 1ms) + "ms";
}

using Wiring = std::tuple<suture::Lane, suture::Duration>;
INSTANTIATE_TEST_SUITE_P(Wirings, Trajectory,
                         testing::Values(Wiring(suture::Lane::Shm, 0ms),
                                         Wiring(suture::Lane::Frame, 0ms),
                                         Wiring(suture::Lane::Rpc, 0ms),
                                         Wiring(suture::Lane::Auto, 50ms),
                                         Wiring(suture::Lane::Frame, 50ms)),
                         nameOfWiring);

/// This comes on top of latency: how the cycles of tasks lie to each other, s.
constexpr double kCycle = 0.001;

TEST_P(Trajectory, IsThatOfOneProcessWithinLatency) {
  const auto& [lane, delay] = GetParam();
  const RecordedRun one(suture::Lane::Auto, 0ms), other(lane, delay);
  double apart = 0, mastersApart = 0;
  for (suture::Duration after{}; after < RecordedRun::kLength; after += 10ms) {
    apart = std::max(apart, (one.slave(after) - other.slave(after)).norm());
    mastersApart = std::max(mastersApart, (one.master(after) - other.master(after)).norm());
  }
  const double speed = one.speed();
  const double explained = speed * std::abs(other.latency() - one.latency());
  RecordProperty("apart_um", std::to_string(1e6 * apart));
  RecordProperty("explained_um", std::to_string(1e6 * explained));
  EXPECT_LT(mastersApart, kCycle * speed / TwoWorkstations::kScale) << "not the same script";
  EXPECT_GT(speed, 0.02) << "it hardly moved";
  EXPECT_LT(apart, explained + kCycle * speed);
  EXPECT_GT(apart, 0.8 * explained - kCycle * speed) << "that is not how late it was";
}

}  // namespace
}  // namespace robots::test
