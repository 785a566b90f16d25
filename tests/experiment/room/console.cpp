#include "experiment/room/console.h"

#include "integration/teleoperation/scene/knot_scene.h"

namespace experiment {

robots::OperatorParameters operatorOf(const Trial& trial) {
  return {.target = robots::test::kKnotTarget, .scale = kScale, .seed = trial.seed};
}

void Console::addTo(suture::Manager& manager) {
  left.addTo(manager, "MTML");
  right.addTo(manager, "MTMR");
  manager.add("Readier", readier_);
  manager.connect("Readier/Arm", "MTMR/Arm");
}

void Console::seat(suture::Manager& manager, suture::Task& surgeon, const Crossing& cross,
                   suture::Duration picturePeriod) {
  manager.add("Surgeon", surgeon);
  manager.connect("Surgeon/Left", "MTML/Arm");
  manager.connect("Surgeon/Right", "MTMR/Arm");
  cross("Surgeon/Vision", "Camera/Vision", {.stream = 2, .period = picturePeriod});
}

void Console::connectOperator(suture::Manager& manager, const Crossing& cross,
                              suture::Duration picturePeriod) {
  cross("Surgeon/Guidance", "Guide/Guidance", {.stream = 2, .period = picturePeriod});
  manager.connect("Surgeon/Registration", "Registration/Registration");
}

}  // namespace experiment
