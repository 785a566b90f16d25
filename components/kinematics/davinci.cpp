#include "kinematics/davinci.h"

#include "kinematics/davinci_links.h"

namespace robots::kinematics {
namespace {

Chain<7> mtm(double yawLower, double yawUpper, double shoulderLower, double platformLower,
             double platformUpper) {
  return {Convention::Standard,
          {{//  alpha      a       d       offset    lower          upper
            {kHalfPi, 0.0, 0.0, -kHalfPi, yawLower, yawUpper},
            {0.0, kMtmUpperArm, 0.0, -kHalfPi, shoulderLower, 1.134},
            {-kHalfPi, kMtmForearm, 0.0, kHalfPi, -0.873, 0.611},
            {kHalfPi, 0.0, kMtmForearmDrop, 0.0, platformLower, platformUpper},
            {-kHalfPi, 0.0, 0.0, 0.0, -1.658, 3.229},
            {kHalfPi, 0.0, 0.0, -kHalfPi, -0.785, 0.785},
            {0.0, 0.0, 0.0, kHalfPi, -8.378, 7.854}}}};
}

}  // namespace

Chain<6> psm() {
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
  tip.linear() << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  return {Convention::Modified,
          {{//  alpha      a       d       offset    lower      upper
            {kHalfPi, 0.0, 0.0, kHalfPi, -1.588, 1.588},
            {-kHalfPi, 0.0, 0.0, -kHalfPi, -0.925025, 0.925025},
            {kHalfPi, 0.0, 0.0, -kPsmCarriage, 0.0, 0.24, JointKind::Prismatic},
            {0.0, 0.0, kPsmShaft, 0.0, -4.53786, 4.53786},
            {-kHalfPi, 0.0, 0.0, -kHalfPi, -1.39626, 1.39626},
            {-kHalfPi, kPsmWrist, 0.0, -kHalfPi, -1.39626, 1.39626}}},
          tip};
}

Chain<7> mtmLeft() { return mtm(-0.698, 1.134, -0.262, -3.578, 1.658); }

Chain<7> mtmRight() { return mtm(-1.134, 0.698, -0.314, -1.658, 3.578); }

Chain<7>::Joints mtmHome() {
  Chain<7>::Joints home = Chain<7>::Joints::Zero();
  home[1] = 0.4;
  home[4] = kHalfPi;
  return home;
}

}  // namespace robots::kinematics
