#pragma once
// What the control of libfranka's robot sends: packed structs with arrays, structs and enums in
// them.

#include <suture/annotate.h>

#include <research_interface/robot/rbk_types.h>

namespace lab::robot {

using CommandHeader = research_interface::robot::CommandHeader<research_interface::robot::Command>;

SUTURE_EXTERNAL_TYPE(research_interface::robot::Command);
SUTURE_EXTERNAL_TYPE(research_interface::robot::MotionGeneratorMode);
SUTURE_EXTERNAL_TYPE(research_interface::robot::RobotState, all(), member(q, unit("rad")));
SUTURE_EXTERNAL_TYPE(CommandHeader);
SUTURE_EXTERNAL_TYPE(research_interface::robot::MoveRequest::Deviation);
SUTURE_EXTERNAL_TYPE(research_interface::robot::MoveRequest);

/// The control of a robot.
class SUTURE_INTERFACE() Control {
 public:
  virtual ~Control() = default;
  SUTURE_COMMAND() virtual void move(const research_interface::robot::MoveRequest& request) = 0;
  SUTURE_COMMAND() virtual const research_interface::robot::RobotState& state() const = 0;
  SUTURE_EVENT()
  suture::EventOf<research_interface::robot::MoveRequest, research_interface::robot::Command> moved;
};

}  // namespace lab::robot
