#pragma once
// The simulated joint drives of a master arm.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/periodic_task.h>
#include <suture/component/provided.h>

#include <chrono>
#include <cstdint>

#include "drives/drives.suture.h"
#include "drives/simulated_drives.h"

namespace robots {

/// Which of a surgeon's two masters: their joints have mirrored limits.
enum class SUTURE_TYPE() MasterSide : std::uint8_t { Left, Right };

struct SUTURE_TYPE() MtmDrivesParameters {
  MasterSide side = MasterSide::Left;
  suture::Duration period = std::chrono::microseconds(667);
  /// How far the measured joints trail their goal: here, the hand that moves the master.
  SUTURE_FIELD(unit("s"), range(0.0001, 10)) double time_constant = 0.01;
  /// How fast the joints can be.
  SUTURE_FIELD(unit("rad/s"), range(0.01, 20)) double angular_rate = 4.0;
};

/// The drives of a master tool manipulator.
class SUTURE_COMPONENT() MtmDrives final : public suture::PeriodicTask, public SimulatedDrives<7> {
 public:
  explicit MtmDrives(const MtmDrivesParameters& parameters);

  void run() override;

 private:
  suture::Provided<Drives> drives_{*this, "Drives", *this};
};

}  // namespace robots
