#pragma once
// These are the two ends of the proof: a seven-joint arm and a client that uses all of its
// contract.

#include <functional>
#include <string>

#include "arm/arm.suture.h"
#include "arm_control/arm_controller.h"
#include "arm_control/crtk_arm.h"
#include "rt/task_thread/arm_user.h"
#include "unit/arm/trailing_joints.h"

namespace proof {

/// Returns a master arm with its seven named joints.
robots::ArmModel<7> masterArm();

/// Does in each cycle what robots::Mtm does, and `also`.
template <class Kind>
class ArmTask final : public Kind, public robots::ArmController<7> {
 public:
  template <class... Options>
  explicit ArmTask(const Options&... options) : Kind(options...), ArmController(masterArm()) {}
  ~ArmTask() override { this->stop(); }

  void run() override {
    if (also) also();
    const suture::Time now = suture::now();
    contract_.advance(now);
    joints_.step(*this, now);
    contract_.publish(now);
    contract_.announce(arm.emit());
  }

  std::function<void()> also;

 private:
  robots::CrtkArm<7> contract_{*this};
  robots::test::TrailingJoints<7> joints_{masterArm(), Joints::Constant(0.1)};

 public:
  suture::Provided<robots::Arm> arm{*this, "Arm", contract_};
};

/// Does in each cycle what ArmUser does, and `also`.
template <class Kind>
class UserTask final : public Kind {
 public:
  template <class... Options>
  explicit UserTask(const Options&... options) : Kind(options...) {}
  ~UserTask() override { this->stop(); }

  void run() override {
    if (also) also();
    user.cycle();
  }

  std::function<void()> also;
  suture::Required<robots::Arm> arm{*this, "Arm"};
  ArmUser user{arm};
};

}  // namespace proof
