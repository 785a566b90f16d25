#pragma once
// These are a hand, a master and a slave that feel each other over a link.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "force_feedback/position_position.h"
#include "hand/hand.h"

namespace robots::test {

/// Masses without friction stand for the arms: of what the da Vinci arms are along the axes of
/// their bases at the tips, as components/dynamics has them (master at home: 1.0, 1.2 and 1.5 kg;
/// slave with its instrument in by 0.12 m: 10.7, 1.4 and 0.9 kg), those of the lightest axes. The
/// hand has the master firmly in its grip, so both move as one.
class TwoArms {
 public:
  static constexpr double kCycle = 0.001;               // s
  static constexpr double kMaster = 1.0, kSlave = 0.9;  // kg

  /// `delay` is in cycles, each way. `wall` is the slave's x beyond which there is a wall, m.
  TwoArms(const PositionPositionModel& model, int delay,
          double wall = std::numeric_limits<double>::infinity())
      : gains_(model.gains),
        feedback_(model),
        wall_(wall),
        toSlave_(static_cast<std::size_t>(delay)),
        toMaster_(static_cast<std::size_t>(delay)) {
    feedback_.beginAt(hand_.position());
  }

  /// The muscles want the hand at `target`.
  void cycle(const Eigen::Vector3d& target) {
    const TipMotion master{hand_.position(), hand_.velocity()};
    const Eigen::Vector3d force = feedback_.force(master, pass(toMaster_, slave_), kCycle);
    const Eigen::Vector3d pull = coupling(gains_, slave_, pass(toSlave_, master));
    hand_.advance(kCycle, target, force);
    given_ += hand_.muscles().cwiseProduct(hand_.position() - master.position);
    moveSlave(pull);
    lowest_ = std::min(lowest_, energyOfHand().minCoeff());
    lowestObserved_ = std::min(lowestObserved_, feedback_.energy().minCoeff());
  }

  /// Returns what the hand has given to the master along each axis, J; its own motion is not
  /// counted.
  Eigen::Vector3d energyOfHand() const { return given_ - kHand / 2 * hand_.velocity().cwiseAbs2(); }
  double lowest() const { return lowest_; }                  ///< J, of that, of any axis
  double lowestObserved() const { return lowestObserved_; }  ///< J, at the motors
  const Hand& hand() const { return hand_; }

 private:
  static constexpr double kHand = HandModel{}.mass;

  static HandModel holding() {
    HandModel model;
    model.mass += kMaster;
    return model;
  }
  static TipMotion pass(std::deque<TipMotion>& link, const TipMotion& motion) {
    link.push_back(motion);
    const TipMotion arrived = link.front();
    link.pop_front();
    return arrived;
  }
  /// Moves the slave by the implicit midpoint rule, as the hand does.
  void moveSlave(const Eigen::Vector3d& pull) {
    constexpr double kWall = 2000;  // N/m
    for (int i = 0; i < 3; ++i) {
      const double depth = i == 0 ? slave_.position[0] - wall_ : 0;
      const double k = depth > 0 ? kWall : 0;
      const double push = 2 * kSlave / kCycle * slave_.velocity[i] - k * std::max(depth, 0.0);
      const double rate = (push + pull[i]) / (2 * kSlave / kCycle + k * kCycle / 2);
      slave_.position[i] += kCycle * rate;
      slave_.velocity[i] = 2 * rate - slave_.velocity[i];
    }
  }

  CouplingGains gains_;
  PositionPosition feedback_;
  Hand hand_{holding()};
  TipMotion slave_;
  double wall_;
  std::deque<TipMotion> toSlave_, toMaster_;
  Eigen::Vector3d given_ = Eigen::Vector3d::Zero();
  double lowest_ = 0, lowestObserved_ = 0;
};

}  // namespace robots::test
