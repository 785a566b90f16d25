// These are the packed structs that libfranka's robot sends, with arrays and structs that are not
// aligned.

#include "values/robot.h"
#include "connected.h"
#include "labs/robot.capnp.h"
#include "labs/robot.suture.h"

namespace lab::robot {

void toWire(const research_interfacerobotRobotStateSlot&, wire::RobotState::Builder);
suture::Errc fromWire(wire::RobotState::Reader, research_interfacerobotRobotStateSlot&,
                      suture::Duration);
bool isValid(const research_interfacerobotRobotStateSlot&, suture::FieldPath* = nullptr);
void toWire(const research_interfacerobotMoveRequestSlot&, wire::MoveRequest::Builder);
suture::Errc fromWire(wire::MoveRequest::Reader, research_interfacerobotMoveRequestSlot&,
                      suture::Duration);
bool isValid(const research_interfacerobotMoveRequestSlot&, suture::FieldPath* = nullptr);

}  // namespace lab::robot

namespace invented {

class RobotProvider final : public suture::EventTask, public lab::robot::Control {
 public:
  void move(const MoveRequest& request) override {
    state_.message_id = request.header.command_id;
    require(port_.emit().moved(request, Command::kMove).has_value(), "moved", "is not emitted");
  }
  const ControlState& state() const override { return state_; }
  void run() override {}

 private:
  ControlState state_{};
  suture::Provided<lab::robot::Control> port_{*this, "Port", *this};
};

void connectRobot(Random& random) {
  MoveRequest heard{};
  int events = 0;
  Connected<lab::robot::Control, RobotProvider> robot([&](auto& port) {
    port.on().moved([&](const MoveRequest& request, Command command) {
      heard = request;
      events += command == Command::kMove ? 1 : 0;
    });
  });
  MoveRequest request{};
  fill(request, random);
  require(robot.port().move(request).has_value(), "move", "the command is not sent");
  robot.until([&] { return events == 1; }, "moved");
  require(same(heard, request), "moved", "the event brings another request");
  const auto state = robot.port().state.fresh().within(10s);
  require(state && state->message_id == request.header.command_id, "state",
          "the read answers another value");
}

void checkRobot(Random& random) {
  namespace robot = lab::robot;
  using StateSlot = robot::research_interfacerobotRobotStateSlot;
  using MoveSlot = robot::research_interfacerobotMoveRequestSlot;
  static_assert(alignof(ControlState) == 1 && alignof(MoveRequest) == 1);
  checkType<ControlState, StateSlot, robot::wire::RobotState>("state", random);
  checkType<MoveRequest, MoveSlot, robot::wire::MoveRequest>("move", random);

  MoveRequest request{};
  checkRefused<MoveSlot>(request, "");
  request.maximum_deviations[1].elbow = kNaN;
  checkRefused<MoveSlot>(request, "maximum_deviations[1].elbow");
  connectRobot(random);
}

}  // namespace invented
