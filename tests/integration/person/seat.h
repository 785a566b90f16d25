#pragma once
// This is where a person sits: a master and what else there is, as the test wants them.

#include <suture/component/device.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>
#include <suture/standard/messages.suture.h>

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "drives/gripper_hand.suture.h"
#include "integration/teleoperation/scene/scripted_arm.h"
#include "pedals/foot_pedals.suture.h"
#include "support/pass.h"
#include "teleop/teleoperation.suture.h"

namespace robots::test {

/// This teleoperation is in the state that the test says, from its next cycle on.
class ScriptedTeleoperation final : public suture::PeriodicTask, public Teleoperation {
 public:
  ScriptedTeleoperation() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~ScriptedTeleoperation() override { stop(); }

  std::atomic<TeleopState> state = TeleopState::Following;

  void enable() override {}
  void disable() override {}
  void set_scale(double) override {}
  void lock_rotation(bool) override {}
  void lock_translation(bool) override {}
  TeleopState teleop_state() const override { return told_; }
  FollowAnchors anchors() const override { return {}; }
  TeleopSettings settings() const override { return {}; }

 private:
  void run() override {
    if (told_ != state) port_.emit().teleop_state(told_ = state);
  }

  TeleopState told_ = TeleopState::Disabled;
  suture::Provided<Teleoperation> port_{*this, "Teleoperation", *this};
};

/// A ScriptedHand is the gripper of the master. Its angle is -1 until the test squeezes it.
class ScriptedHand final : public suture::PeriodicTask, public GripperHand {
 public:
  ScriptedHand() : PeriodicTask({.period = std::chrono::milliseconds(1)}) {}
  ~ScriptedHand() override { stop(); }

  std::atomic<double> angle = -1;

  void squeeze(double fingers) override { angle = fingers; }

 private:
  void run() override {}

  suture::Provided<GripperHand> port_{*this, "Hand", *this};
};

/// Hears what a person's component says.
struct Listener final : suture::Device {
  Listener() {
    from.on().status([this](const suture::Message& said) { statuses.push_back(said.text); });
    from.on().error([this](const suture::Message& said) { errors.push_back(said.text); });
  }

  suture::Required<suture::Messages> from{*this, "From"};
  std::vector<std::string> statuses, errors;
};

/// Hears of the pedals.
struct Feet final : suture::Device {
  Feet() {
    pedals.on().clutch([this](bool pressed) { clutch.push_back(pressed); });
  }
  suture::Required<FootPedals> pedals{*this, "Pedals"};
  std::vector<bool> clutch;
};

/// `Person` is the component that the test drives the master by. `person` lives as long as this.
struct Seat {
  ~Seat() { manager.stop(); }

  /// The arm is ready, and the first cycles have passed.
  void start(suture::Task& person) {
    connect(person);
    begin();
  }
  void connect(suture::Task& person) {
    manager.add("MTM", master);
    manager.add("Person", person);
    manager.add("Listener", listener);
    manager.connect("Person/Master", "MTM/Arm");
    manager.connect("Listener/From", "Person/Messages");
  }
  void begin() {
    manager.start();
    suture::pass(std::chrono::milliseconds(10));
    EXPECT_TRUE(master.goals().empty());
  }
  void addTeleoperation() {
    manager.add("Teleop", teleoperation);
    manager.connect("Person/Teleoperation", "Teleop/Teleoperation");
  }
  void addHand() {
    manager.add("MTMDrives", hand);
    manager.connect("Person/Hand", "MTMDrives/Hand");
  }
  void addFeet() {
    manager.add("Feet", feet);
    manager.connect("Feet/Pedals", "Person/Pedals");
  }
  /// Returns how many goals the master gets.
  std::size_t goalsIn(suture::Duration duration) {
    master.forgetGoals();
    suture::pass(duration);
    return master.goals().size();
  }
  Eigen::Vector3d position() const { return master.pose().translation(); }

  ScriptedArm master;
  ScriptedTeleoperation teleoperation;
  ScriptedHand hand;
  Listener listener;
  Feet feet;
  suture::Manager manager{"console"};
};

}  // namespace robots::test
