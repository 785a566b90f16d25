#pragma once
// These are the parties of a system with an emergency stop: a desk, two pairs of arms, an
// endoscope, and a person who presses.

#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "arm/arm.suture.h"
#include "bench/image_viewer.h"
#include "coordinator/coordinator.h"
#include "drives/drives.suture.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "registration/registration_table.h"
#include "strand/strand_simulation.h"
#include "vision/synthetic_endoscope.h"

namespace bench {

inline constexpr std::size_t kArmCount = 4;

/// Says where an arm is: "left:PSM2".
struct ArmPlace {
  const char* process;
  const char* name;
};
inline constexpr std::array<ArmPlace, kArmCount> kArms{
    {{"left", "MTML"}, {"left", "PSM2"}, {"right", "MTMR"}, {"right", "PSM1"}}};

/// An ArmPair is a master and a slave, whose drives need a permit, and a viewer that looks at the
/// images.
struct ArmPair {
  /// `first` is the place in kArms.
  ArmPair(std::size_t first, robots::Side side);
  void addTo(suture::Manager& manager);

  static constexpr suture::Duration kPermit = std::chrono::milliseconds(30);

  const std::size_t first;
  robots::test::DrivenMtm master;
  robots::test::DrivenPsm slave{kPermit};
  ImageViewer viewer;
};

/// The slaves stand 10 cm apart, and the camera sees what is between them.
robots::SceneFrames sceneOfTwoArms();

struct StopDesk {
  StopDesk();
  void addTo(suture::Manager& manager) { manager.add("Coordinator", coordinator); }

  robots::Coordinator coordinator{robots::CoordinatorParameters{}};
};

/// A StopVision is an endoscope that looks at a strand between both slaves.
struct StopVision {
  void addTo(suture::Manager& manager);

  robots::RegistrationTable registration{sceneOfTwoArms()};
  robots::StrandSimulation strand{robots::StrandParameters{}};
  robots::SyntheticEndoscope endoscope{robots::EndoscopeParameters{}};
};

/// The thread of the measurement uses it. Presses, releases and enables.
class StopPanel final : public suture::Device {
 public:
  suture::Required<robots::EmergencyStop> stop{*this, "Stop"};
  suture::Required<robots::Arm> mtml{*this, "MTML"}, psm2{*this, "PSM2"}, mtmr{*this, "MTMR"},
      psm1{*this, "PSM1"};

  std::array<suture::Required<robots::Arm>*, kArmCount> arms() {
    return {&mtml, &psm2, &mtmr, &psm1};
  }
  /// Releases the last press. Returns false if it has not heard of one since the last release.
  bool release() {
    const auto permit = stop.permit();
    if (!permit || permit->press == released_) return false;
    released_ = permit->press;
    return stop.release(released_).has_value();
  }

 private:
  std::uint64_t released_ = 0;
};

/// Sees by what all drives measured when they stopped. It looks more often than they move, and so
/// misses a cycle of theirs seldom; then a stop counts as one cycle later than it was.
class StopWatch final : public suture::PeriodicTask {
 public:
  StopWatch();

  /// Any thread: tells if all drives have that power.
  bool all(robots::DrivePower power) const;
  /// Any thread: forgets what has stopped until now.
  void reset();
  /// Any thread: returns the cycle in which the last of the drives stopped; zero before all have.
  suture::Time allStopped() const;

 private:
  void run() override;

  suture::Required<robots::Drives> mtml_{*this, "MTML"}, psm2_{*this, "PSM2"}, mtmr_{*this, "MTMR"},
      psm1_{*this, "PSM1"};
  std::array<std::atomic<robots::DrivePower>, kArmCount> power_{};
  std::array<std::atomic<std::int64_t>, kArmCount> stopped_{};  // ns
};

}  // namespace bench
