#pragma once
// A setpoint says where joints are to be. A move or a line may be under way, along which it changes
// in each cycle.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "arm_control/motion/joint_line.h"
#include "arm_control/motion/joint_move.h"
#include "arm_control/motion/setpoint_rate.h"
#include "timing/seconds.h"

namespace robots {

/// One thread; never allocates. Joints are in rad, or m for a prismatic one, and rates per second.
template <int N>
class Setpoint {
 public:
  using Joints = Eigen::Matrix<double, N, 1>;

  using Limits = typename JointMove<N>::Limits;

  explicit Setpoint(const Limits& limits) : limits_(limits), rate_(limits.rate) {}

  const Joints& joints() const { return joints_; }
  /// Returns how fast joints() changes, whether by put(), by a move or by a line.
  Joints rate() const { return rate_.rate(); }
  bool isMoving() const { return move_.has_value(); }
  /// Returns true if a move or a line has begun since the last step().
  bool hasBegun() const { return begun_; }
  /// Returns where the move ends, or where the joints shall be if there is none.
  const Joints& endOfMove() const { return move_ ? move_->to() : joints_; }
  /// Does the same for a line.
  const Joints& endOfLine() const { return line_ ? line_->to() : joints_; }

  /// Changes it at once. A move or a line that is under way changes it again in the next step().
  void put(const Joints& joints) { joints_ = joints; }
  /// Changes it at once, to where the joints are at rest.
  void rest(const Joints& joints) {
    joints_ = joints;
    reached_ = joints;
    rate_.rest(joints);
  }
  /// Stays where it is, though the joints may not have arrived.
  void stay() { rate_.rest(joints_); }
  /// Returns true if joints that keep their rate limits can follow put(goal) with a delay of
  /// `horizon` seconds at most. Goals that come one after the other may not add up to more.
  bool mayBePut(const Joints& goal, double horizon) const {
    return ((goal - reached_).cwiseAbs().array() <= (horizon * limits_.rate).array()).all();
  }
  /// Says which share of their limits moves may use from the next one on.
  void limitMoves(const MoveRatios& ratios) { ratios_ = ratios; }

  /// Begins a move to rest at `goal`, in place of what is under way. `now` is the cycle before its
  /// first step.
  void move(const Joints& goal, suture::Time now) {
    end();
    planMove(goal, now);
    begun_ = true;
  }
  /// Returns how long a line to a goal that comes now should take, in s: as long as it took this
  /// goal to come after the last one, since the next is expected to take as long. Returns 0 if no
  /// stream of goals is under way; the line then takes as long as the rates need.
  double untilNextGoal(suture::Time now) const {
    constexpr double kLongest = 0.5;  // s; goals further apart are no stream
    if (!line_) return 0;
    const double since = secondsBetween(line_->begin(), now);
    if (since >= kLongest) return 0;
    return since > 0 ? since : line_->wanted();  // two goals in one cycle
  }
  /// Begins a line to `goal`, in place of what is under way, that takes `wanted` seconds.
  void interpolate(const Joints& goal, suture::Time now, double wanted) {
    end();
    planLine(goal, now, wanted);
    begun_ = true;
  }
  /// Puts the setpoint at `joints`, at rest. A move or a line that is under way is planned anew
  /// from there to its goal.
  void beginAnew(const Joints& joints, suture::Time now) {
    rest(joints);
    if (move_) planMove(Joints(move_->to()), now);
    if (line_) planLine(Joints(line_->to()), now, line_->wanted());
  }
  /// Ends what is under way. Returns true if that was a move.
  bool end() {
    const bool moved = isMoving();
    line_.reset();
    move_.reset();
    begun_ = false;
    return moved;
  }

  /// Call this once a cycle. Returns true if a move has reached its end, where it stays.
  bool step(suture::Time now) {
    bool reached = false;
    if (line_) joints_ = line_->at(now);
    if (move_) {
      const double t = secondsBetween(moveStart_, now);
      // A joint that brakes to a limit may be rounded beyond it.
      joints_ = move_->at(t).cwiseMax(limits_.lower).cwiseMin(limits_.upper);
      reached = t >= move_->duration();
    }
    rate_.update(now, joints_);
    const Joints most = limits_.rate * secondsBetween(std::exchange(stepped_, now), now);
    reached_ += (joints_ - reached_).cwiseMin(most).cwiseMax(-most);
    begun_ = false;
    return reached;
  }

 private:
  void planMove(const Joints& goal, suture::Time now) {
    move_.emplace(typename JointMove<N>::Start{joints_, rate()}, goal, limits_, ratios_);
    moveStart_ = now;
  }
  void planLine(const Joints& goal, suture::Time now, double wanted) {
    line_.emplace(joints_, goal, limits_.rate, now, wanted);
  }

  const Limits limits_;
  MoveRatios ratios_;
  Joints joints_ = Joints::Zero();
  Joints reached_ = Joints::Zero();  // by joints that follow it at their rate limits
  suture::Time stepped_;
  SetpointRate<N> rate_;
  std::optional<JointMove<N>> move_;
  suture::Time moveStart_;
  std::optional<JointLine<N>> line_;
  bool begun_ = false;
};

}  // namespace robots
