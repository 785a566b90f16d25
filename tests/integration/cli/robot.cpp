// This is a process with one of everything: cli_robot <manager address> <process name>. It provides
// Hand/Gripper, whose contract derives from robots::Arm, and requires arms and names. It ends on
// SIGTERM.

#include <suture/component/task/event_task.h>
#include <suture/manager/manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/keys.h>

#include <memory>
#include <stdexcept>

#include "robots/arm.suture.h"
#include "robots/gripper.suture.h"
#include "support/hosted_process.h"

namespace {

using robots::Everything;
using robots::Mode;
using robots::PoseStamped;

/// Keeps what it is told.
class Hand final : public suture::EventTask, public robots::Gripper {
 public:
  Hand() {
    gripper_.declareFrames({.reference = "wrist", .moving = "fingers"});
    everything_.label = "hand";
    everything_.bytes = {1, 2, 255};
    everything_.flags = {true, false};
    everything_.names = {"left", "right"};
    everything_.modes = {Mode::Disabled, Mode::Servo};  // zero, as it begins, is no mode
    everything_.goal.pose.translation().x() = 0.5;
    everything_.ratio = 0.1F;
    everything_.point.y() = 2;
  }

  void enable() override {
    everything_.mode = Mode::HoldStill;
    gripper_.emit().mode_changed(everything_.mode);
    gripper_.emit().stopped();
  }
  void servo_cp(const PoseStamped& goal) override { everything_.goal = goal; }
  void set_speed(double speed) override {
    everything_.speed = speed;
    gripper_.emit().moved(everything_.goal, speed, everything_.mode);
  }
  PoseStamped measured_cp() const override { return everything_.goal; }
  Mode mode() const override { return everything_.mode; }
  const Everything& everything() const override { return everything_; }
  const Everything& inverse_kinematics(const PoseStamped&, double) const override {
    return everything_;
  }
  bool grasp(double width, Mode) override {
    if (width < 0) throw std::runtime_error("the width is negative");
    return width > 0;
  }
  std::uint32_t next_token() override { return ++token_; }
  void open(double width) override {
    opening_ = width;
    gripper_.emit().gripped(width, width == 0);
  }
  double opening() const override { return opening_; }
  bool fits(double width) const override { return width <= 0.1; }

 private:
  void run() override {}

  double opening_ = 0;
  std::uint32_t token_ = 0;
  Everything everything_;
  suture::Provided<robots::Gripper> gripper_{*this, "Gripper", *this};
};

/// Requires interfaces and provides none. All that it could read is too old for its connection.
class Surgeon final : public suture::EventTask {
 public:
  Surgeon() { far_.declareFrames({.reference = "camera", .moving = ""}); }

 private:
  void run() override { (void)gripper_.opening(); }

  suture::Required<robots::Arm> arm_{*this, "Arm"};
  suture::Required<robots::Gripper> gripper_{*this, "Gripper"};
  suture::Required<robots::Names> names_{*this, "Names"};
  suture::Required<robots::Arm> far_{*this, "FarArm"};
};

}  // namespace

/// Arguments: the address of the global manager, the own name and, for tls://, the folder of keys.
suture::Security securityOf(char** argv) {
  if (argv[3] == nullptr) return {};
  return {.keys = std::make_shared<const suture::tls::Keys>(argv[3], argv[2])};
}

int main(int, char** argv) {
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    Hand hand;
    Surgeon surgeon;
    suture::Manager manager(argv[2], argv[1], securityOf(argv));
    manager.add("Hand", hand);
    manager.add("Surgeon", surgeon);
    manager.start();
    manager.connect(
        "Surgeon/Gripper", "Hand/Gripper",
        {.contract = {.maxAge = std::chrono::nanoseconds(1), .resume = suture::Resume::Operator}});
    process.awaitEnd();
    manager.stop();
  });
}
