#include <kinematics/davinci.h>

#include <cstdio>

#include "grasp/grasp.suture.h"

int main() {
  const auto tip = robots::kinematics::psm().forward({});
  grasp::Grasp taken;
  taken.at.pose = tip;
  taken.force = 2;
  grasp::GraspSlot slot;
  if (!store(taken, slot)) return 1;
  std::printf("%g N\n", slot.force);
}
