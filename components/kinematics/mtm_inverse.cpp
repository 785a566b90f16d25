#include "kinematics/mtm_inverse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/candidates.h"
#include "kinematics/davinci_links.h"
#include "kinematics/mtm_wrist.h"

namespace robots::kinematics {
namespace {

using Eigen::Vector3d;
using MtmJoints = Chain<7>::Joints;

// Returns the yaw that turns the arm's plane to the wrist; the opposite yaw does so too. If the
// wrist is on the yaw's axis, every yaw does, and this returns `otherwise`.
double yawToward(const Vector3d& wrist, double otherwise) {
  if (std::hypot(wrist.x(), wrist.y()) <= kOpenLength) return otherwise;
  return std::atan2(wrist.y(), wrist.x()) + kHalfPi;
}

// A Reach is the triangle of the upper arm, the line from the elbow to the wrist's centre, and the
// line between their ends.
struct Reach {
  double forearm = std::hypot(kMtmForearm, kMtmForearmDrop);  // m
  double bend;  // cosine of the outer angle between the upper arm and the forearm

  explicit Reach(const Vector3d& wrist)
      : bend((wrist.squaredNorm() - kMtmUpperArm * kMtmUpperArm - forearm * forearm) /
             (2 * kMtmUpperArm * forearm)) {}
  bool isWithin() const { return std::abs(bend) <= 1 + kLimitSlack; }
};

// Returns joints of which the first three lead to the wrist's centre, or point at it if it is out
// of reach; those of the wrist are zero.
MtmJoints armAt(const Vector3d& wrist, const Reach& reach, double yaw, double elbowSide) {
  const double outward = wrist.x() * std::sin(yaw) - wrist.y() * std::cos(yaw);
  const double bend = elbowSide * std::acos(std::clamp(reach.bend, -1.0, 1.0));
  const double lead =
      std::atan2(reach.forearm * std::sin(bend), kMtmUpperArm + reach.forearm * std::cos(bend));
  MtmJoints q = MtmJoints::Zero();
  q[0] = yaw;
  q[1] = std::atan2(wrist.z(), outward) - lead + kHalfPi;
  q[2] = bend - std::atan2(kMtmForearmDrop, kMtmForearm) - kHalfPi;
  return q;
}

std::array<MtmJoints, 4> armsAt(const Chain<7>& chain, const Vector3d& wrist, const Reach& reach,
                                const MtmJoints& start) {
  const double yaw = yawToward(wrist, start[0]);
  std::array<MtmJoints, 4> arms{armAt(wrist, reach, yaw, 1), armAt(wrist, reach, yaw, -1),
                                armAt(wrist, reach, yaw + std::numbers::pi, 1),
                                armAt(wrist, reach, yaw + std::numbers::pi, -1)};
  for (MtmJoints& q : arms) {
    for (int i = 0; i < 3; ++i) {
      q[i] = nearestTurn(q[i], start[i], chain.lower()[i], chain.upper()[i]);
    }
  }
  return arms;
}

bool armIsWithin(const Chain<7>& chain, const MtmJoints& q) {
  return (q - chain.clamp(q)).head<3>().cwiseAbs().maxCoeff() <= kLimitSlack;
}

MtmWrist wristOf(const Chain<7>& chain, const MtmJoints& arm, const Eigen::Isometry3d& goal,
                 const MtmJoints& start) {
  return {chain, chain.link(arm, 3).linear().transpose() * goal.linear(), start};
}

double platformOf(const Chain<7>& chain, const MtmJoints& start) { return chain.clamp(start)[3]; }

// Adds the joints of the wrist. If their limits admit none, the platform keeps its angle.
MtmJoints withWrist(const Chain<7>& chain, MtmJoints arm, const Eigen::Isometry3d& goal,
                    const MtmJoints& start) {
  const MtmWrist wrist = wristOf(chain, arm, goal, start);
  const auto within = armIsWithin(chain, arm) ? wrist.nearest() : std::nullopt;
  arm.tail<4>() = within ? *within : wrist.at(platformOf(chain, start));
  return arm;
}

}  // namespace

InverseSolution<7> mtmInverse(const Chain<7>& chain, const Eigen::Isometry3d& goal,
                              const MtmJoints& start, Postures postures) {
  Candidates<7> candidates(chain, start, postures);
  if (!goal.matrix().allFinite()) return candidates.choose(goal, false);
  const Reach reach(goal.translation());
  for (const MtmJoints& arm : armsAt(chain, goal.translation(), reach, start)) {
    candidates.add(withWrist(chain, arm, goal, start));
  }
  return candidates.choose(goal, reach.isWithin());
}

std::optional<MtmJoints> mtmAtPlatform(const Chain<7>& chain, const Eigen::Isometry3d& goal,
                                       double platform, const MtmJoints& start) {
  const Reach reach(goal.translation());
  if (!goal.matrix().allFinite() || !reach.isWithin()) return std::nullopt;
  auto arms = armsAt(chain, goal.translation(), reach, start);
  const auto rank = [&](const MtmJoints& arm) {
    const double distance = (arm - start).head<3>().squaredNorm();
    return std::pair{!armIsWithin(chain, arm), distance};
  };
  MtmJoints q = *std::min_element(
      arms.begin(), arms.end(),
      [&](const MtmJoints& one, const MtmJoints& two) { return rank(one) < rank(two); });
  q.tail<4>() = wristOf(chain, q, goal, start).at(platform);
  return q;
}

}  // namespace robots::kinematics
