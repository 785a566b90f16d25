#include "bench/stop/parties.h"

#include <algorithm>
#include <numbers>

#include "bench/placement.h"

namespace bench {

using robots::DrivePower;
using suture::Time;

ArmPair::ArmPair(std::size_t firstArm, robots::Side side) : first(firstArm), master(side, kPermit) {
  master.drives.schedule(urgent(80));
  slave.drives.schedule(urgent(80));
}

void ArmPair::addTo(suture::Manager& manager) {
  master.addTo(manager, kArms[first].name);
  slave.addTo(manager, kArms[first + 1].name);
  manager.add(std::string("Viewer") + kArms[first].name, viewer);
}

robots::SceneFrames sceneOfTwoArms() {
  robots::SceneFrames scene;
  scene.left_base = Eigen::Translation3d(-0.05, 0, 0);
  scene.right_base = Eigen::Translation3d(0.05, 0, 0);
  const Eigen::AngleAxisd down(5 * std::numbers::pi / 6, -Eigen::Vector3d::UnitX());
  scene.camera = Eigen::Translation3d(0, -0.06, -0.052) * down;
  return scene;
}

StopDesk::StopDesk() { coordinator.schedule(urgent(75)); }

void StopVision::addTo(suture::Manager& manager) {
  manager.add("Registration", registration);
  manager.add("Strand", strand);
  manager.add("Endoscope", endoscope);
  manager.connect("Strand/Registration", "Registration/Registration");
  manager.connect("Endoscope/Registration", "Registration/Registration");
  manager.connect("Endoscope/Strand", "Strand/Strand");
}

StopWatch::StopWatch()
    : PeriodicTask({.period = std::chrono::microseconds(500), .scheduling = urgent(60)}) {}

void StopWatch::run() {
  const std::array<suture::Required<robots::Drives>*, kArmCount> drives{&mtml_, &psm2_, &mtmr_,
                                                                        &psm1_};
  for (std::size_t i = 0; i < kArmCount; ++i) {
    const auto feedback = drives[i]->feedback();
    if (!feedback) continue;
    if (feedback->power == DrivePower::Stopped && stopped_[i].load() == 0) {
      stopped_[i] = suture::toNanoseconds(feedback->stamp);
    }
    power_[i] = feedback->power;
  }
}

bool StopWatch::all(DrivePower power) const {
  return std::all_of(power_.begin(), power_.end(), [&](const auto& one) { return one == power; });
}

void StopWatch::reset() {
  for (auto& one : stopped_) one = 0;
}

Time StopWatch::allStopped() const {
  std::int64_t last = 0;
  for (const auto& one : stopped_) {
    if (one == 0) return {};
    last = std::max(last, one.load());
  }
  return suture::fromNanoseconds(last);
}

}  // namespace bench
