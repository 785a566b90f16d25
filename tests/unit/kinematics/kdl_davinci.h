#pragma once
// These describe the da Vinci arms a second time, to KDL, so that its results can check ours.

#include "kinematics/davinci_links.h"
#include "unit/kinematics/kdl_oracle.h"

namespace robots::kinematics::test {

inline KDL::Chain kdlPsm() {
  return kdlModified<6>({{{kHalfPi, 0, 0, kHalfPi},
                          {-kHalfPi, 0, 0, -kHalfPi},
                          {kHalfPi, 0, 0, -0.4318, KDL::Joint::TransZ},
                          {0, 0, 0.4162, 0},
                          {-kHalfPi, 0, 0, -kHalfPi},
                          {-kHalfPi, 0.0091, 0, -kHalfPi}}},
                        KDL::Rotation(0, -1, 0, 0, 0, 1, -1, 0, 0));
}

inline KDL::Chain kdlMtm() {
  return kdlStandard<7>({{{kHalfPi, 0, 0, -kHalfPi},
                          {0, 0.2794, 0, -kHalfPi},
                          {-kHalfPi, 0.3645, 0, kHalfPi},
                          {kHalfPi, 0, 0.1506, 0},
                          {-kHalfPi, 0, 0, 0},
                          {kHalfPi, 0, 0, -kHalfPi},
                          {0, 0, 0, kHalfPi}}});
}

}  // namespace robots::kinematics::test
