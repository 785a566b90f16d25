#pragma once
// This is the operator's side of the link: two masters, and the operator who holds them.

#include <suture/component/required.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <functional>

#include "arm/arm.suture.h"
#include "arm/arm_watch.h"
#include "experiment/trial.h"
#include "integration/teleoperation/scene/driven_arm.h"
#include "surgeon/operator.h"

namespace experiment {

/// Connects a required interface of one side to a provided one of the other.
using Crossing =
    std::function<void(const char* required, const char* provided, const Traffic& traffic)>;

/// Gives an arm power and homes it, as the guide does with those that it drives.
class Readier final : public suture::PeriodicTask {
 public:
  Readier() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}

 private:
  void run() override { watch_.prepare(); }

  suture::Required<robots::Arm> arm_{*this, "Arm"};
  robots::ArmWatch watch_{arm_};
};

/// Returns the operator who carries the knot in a trial.
robots::OperatorParameters operatorOf(const Trial& trial);

/// One thread uses it. It must outlive the manager's work.
class Console {
 public:
  void addTo(suture::Manager& manager);
  /// Adds the task that moves the masters, as "Surgeon", and looks. It requires "Left", "Right" and
  /// "Vision"; an operator also what connectOperator() connects. `picturePeriod` is that of the
  /// camera.
  static void seat(suture::Manager& manager, suture::Task& surgeon, const Crossing& cross,
                   suture::Duration picturePeriod);
  /// Connects an operator. Both sides know beforehand where things stand: "Registration" is of this
  /// process.
  static void connectOperator(suture::Manager& manager, const Crossing& cross,
                              suture::Duration picturePeriod);

  robots::test::DrivenMtm left{robots::Side::Left}, right{robots::Side::Right};

 private:
  Readier readier_;  // the hand that leads nothing holds a master all the same
};

}  // namespace experiment
