#pragma once
// The two ends of the proof: a seven-joint arm with the complete CRTK interface, and a client that
// uses all of it.

#include <functional>
#include <string>

#include "arm/arm.suture.h"
#include "arm/crtk_arm.suture.h"
#include "arm/crtk_face.h"
#include "arm/simulated_arm.h"
#include "rt/task_thread/arm_user.h"

namespace proof {

/// A master arm with its seven named joints.
robots::ArmModel<7> masterArm();

/// Does in each cycle what robots::Mtm does, and `also`.
template <class Kind>
class ArmTask final : public Kind, public robots::SimulatedArm<7> {
 public:
  template <class... Options>
  explicit ArmTask(const Options&... options) : Kind(options...), SimulatedArm(masterArm()) {}
  ~ArmTask() override { this->stop(); }

  void run() override {
    if (also) also();
    const suture::Time now = suture::now();
    face_.advance(now);
    step(now);
    face_.publish(now);
    face_.announce(crtk.emit());
    announce(arm_.emit());
  }

  std::function<void()> also;

 private:
  robots::CrtkFace<7> face_{*this};
  suture::Provided<robots::Arm> arm_{*this, "Arm", *this};

 public:
  suture::Provided<robots::CrtkArm> crtk{*this, "Crtk", face_};
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
  suture::Required<robots::CrtkArm> arm{*this, "Arm"};
  ArmUser user{arm};
};

}  // namespace proof
