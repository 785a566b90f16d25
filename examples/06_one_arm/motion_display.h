#pragma once
// This is the client that this example adds. It prints how far a master and a slave have moved.

#include <suture/annotate.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "arm/arm.suture.h"
#include "teleop/teleoperation.suture.h"

namespace watching {

/// Prints twice a second, and counts from where both arms were when the slave last began to follow.
class SUTURE_COMPONENT() MotionDisplay final : public suture::PeriodicTask {
 public:
  MotionDisplay();

  void run() override;

 private:
  /// Returns where the tip is, in m; none, and prints so, if the arm does not say.
  std::optional<Eigen::Vector3d> tipOf(suture::Required<robots::Arm>& arm);
  void print(const std::string& text) const;

  struct Tips {
    Eigen::Vector3d master, slave;
  };

  suture::Required<robots::Arm> master_{*this, "Master"};
  suture::Required<robots::Arm> slave_{*this, "Slave"};
  suture::Required<robots::Teleoperation> teleoperation_{*this, "Teleoperation"};
  std::optional<Tips> began_;
  std::uint64_t entry_ = 0;  // the time of following that it counts from
};

}  // namespace watching
