// This is the state of an arm of libfranka, with what its hooks carry.

#include "values/franka.h"
#include "connected.h"
#include "labs/franka.capnp.h"
#include "labs/franka.suture.h"

namespace lab {

void toWire(const frankaRobotStateSlot&, wire::RobotState::Builder);
suture::Errc fromWire(wire::RobotState::Reader, frankaRobotStateSlot&, suture::Duration);
bool isValid(const frankaRobotStateSlot&, suture::FieldPath* = nullptr);
void toWire(const frankaRecordSlot&, wire::Record::Builder);
suture::Errc fromWire(wire::Record::Reader, frankaRecordSlot&, suture::Duration);
bool isValid(const frankaRecordSlot&, suture::FieldPath* = nullptr);
void toWire(const frankaVacuumGripperStateSlot&, wire::VacuumGripperState::Builder);
suture::Errc fromWire(wire::VacuumGripperState::Reader, frankaVacuumGripperStateSlot&,
                      suture::Duration);
bool isValid(const frankaVacuumGripperStateSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class FrankaProvider final : public suture::EventTask, public lab::FrankaArm {
 public:
  void command(const franka::RobotCommand& command) override {
    record_.command = command;
    record_.state.tau_J_d = command.torques.tau_J;
    record_.state.current_errors = std::array<bool, 41>{false, true};
    record_.state.time += franka::Duration(1);
    require(port_.emit().stopped(record_).has_value(), "stopped", "is not emitted");
  }
  const franka::RobotState& state() const override { return record_.state; }
  franka::RobotMode mode() const override { return franka::RobotMode::kReflex; }
  const franka::VacuumGripperState& gripper() const override { return gripper_; }
  void run() override {}

 private:
  franka::Record record_;
  franka::VacuumGripperState gripper_;
  suture::Provided<lab::FrankaArm> port_{*this, "Port", *this};
};

void connectFranka(Random& random) {
  franka::Record heard;
  Connected<lab::FrankaArm, FrankaProvider> arm([&](auto& port) {
    port.on().stopped([&](const franka::Record& record) { heard = record; });
  });
  for (std::uint64_t round = 1; round <= 20; ++round) {
    franka::RobotCommand command;
    fill(command, random);
    require(arm.port().command(command).has_value(), "command", "is not sent");
    arm.until([&] { return heard.state.time.toMSec() == round; }, "stopped");
    require(same(heard.command, command), "stopped", "brings another command");
    require(heard.state.current_errors.cartesian_position_limits_violation, "stopped",
            "brings no errors");
    const auto state = arm.port().state.fresh().within(10s);
    require(state && same(*state, heard.state), "state", "is another one");
  }
  const auto mode = arm.port().mode.fresh().within(10s);
  require(mode && *mode == franka::RobotMode::kReflex, "mode", "is another one");
}

void checkFranka(Random& random) {
  using lab::frankaRecordSlot, lab::frankaRobotStateSlot, lab::frankaVacuumGripperStateSlot;
  checkType<franka::RobotState, frankaRobotStateSlot, lab::wire::RobotState>("RobotState", random);
  checkType<franka::VacuumGripperState, frankaVacuumGripperStateSlot,
            lab::wire::VacuumGripperState>("VacuumGripperState", random);
  checkType<franka::Record, frankaRecordSlot, lab::wire::Record>("Record", random);

  franka::Record record;
  checkRefused<frankaRecordSlot>(record, "");
  record.state.q[3] = kNaN;
  checkRefused<frankaRecordSlot>(record, "state.q[3]");
  record.state.q[3] = 0;
  record.state.m_ee = 21;
  checkRefused<frankaRecordSlot>(record, "state.m_ee");
  record.state.m_ee = 20;
  record.command.torques.tau_J[6] = kInfinity;
  checkRefused<frankaRecordSlot>(record, "command.torques[6]");
  connectFranka(random);
}

}  // namespace invented
