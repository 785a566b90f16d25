#include "experiment/room/sides.h"

#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <chrono>
#include <string>
#include <thread>

#include "experiment/experiment.h"
#include "experiment/forked.h"
#include "experiment/room/console.h"
#include "experiment/room/operating_table.h"
#include "experiment/room/witness.h"
#include "integration/teleoperation/scene/knot_scene.h"
#include "registration/registration_table.h"
#include "surgeon/operator.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;

constexpr suture::Duration kPatience = 30s;
constexpr suture::Duration kLook = 10ms;

std::string managerAddress() { return std::string("tcp://") + kTableAddress + ":7700?insecure"; }

/// Connects to the process of that name: the link between them is a real one.
Crossing crossingTo(suture::Manager& manager, const std::string& process) {
  return [&manager, process](const char* required, const char* provided, const Traffic&) {
    manager.connect(required, process + ":" + provided, {.patience = kPatience});
  };
}

void watch(suture::Manager& manager, Witness& witness, const std::string& left,
           const std::string& right) {
  manager.add("Witness", witness);
  manager.connect("Witness/Left", left + "/Arm");
  manager.connect("Witness/Right", right + "/Arm");
}

void awaitLength(const Witness& witness) {
  const suture::Time begin = suture::now();
  const auto isOver = [&] {
    const suture::Time since = witness.guidedSince(), now = suture::now();
    if (since == suture::Time{}) return now - begin > kPatience;
    return now - since > std::chrono::duration<double>(kLength) + kLook;
  };
  while (!isOver()) std::this_thread::sleep_for(kLook);
}

}  // namespace

void playConsole(const Trial& trial, const LinkEnd& end, std::FILE* record) {
  end.enter();
  Console console;
  robots::RegistrationTable registration(robots::test::knotScene());
  robots::Operator surgeon(operatorOf(trial));
  Witness witness;
  suture::Manager manager("console", managerAddress(), kPatience);
  console.addTo(manager);
  manager.add("Registration", registration);
  watch(manager, witness, "MTML", "MTMR");
  const Crossing cross = crossingTo(manager, "table");
  const suture::Duration picturePeriod = CameraModel{}.period;
  manager.start();
  Console::seat(manager, surgeon, cross, picturePeriod);
  Console::connectOperator(manager, cross, picturePeriod);
  manager.start();  // the surgeon too, who has been added since
  Forked::awaitEnd();
  manager.stop();
  write(witness.record(), record);
}

void playTable(const Trial& trial, const LinkEnd& end, std::FILE* record) {
  end.enter();
  suture::loop::ControlThread control;
  const suture::GlobalManager names(control, managerAddress());
  OperatingTable table(trial, {.seed = trial.seed});
  Witness witness;
  suture::Manager manager("table", names.address());
  table.addTo(manager);
  watch(manager, witness, "PSM2", "PSM1");
  manager.connect("Witness/Strand", "Strand/Strand");
  manager.connect("Witness/Guidance", "Guide/Guidance");
  manager.start();
  table.connectMasters(crossingTo(manager, "console"));
  awaitLength(witness);
  manager.stop();
  write(witness.record(), record);
}

}  // namespace experiment
