#pragma once
// These convert between the types of the complete arm interface and Cap'n Proto, as one writes it
// by hand: the yardstick for what suturec writes. Reading throws kj::Exception at what cannot be an
// argument.

#include <suture/standard/messages.capnp.h>
#include <suture/standard/messages.h>

#include "arm/arm.capnp.h"
#include "robot_types/cartesian.h"
#include "robot_types/joint_commands.h"
#include "robot_types/joints.h"
#include "robot_types/messages.h"
#include "robot_types/operating_state.h"
#include "robot_types/pose.h"

namespace handwritten {

namespace wire = robots::wire;

void write(const robots::PoseStamped& value, wire::PoseStamped::Builder out);
void write(const robots::TransformStamped& value, wire::TransformStamped::Builder out);
void write(const robots::JointState& value, wire::JointState::Builder out);
void write(const robots::JointGoal& value, wire::JointGoal::Builder out);
void write(const robots::JointSolution& value, wire::JointSolution::Builder out);
void write(const robots::JointVelocityGoal& value, wire::JointVelocityGoal::Builder out);
void write(const robots::JointEffortGoal& value, wire::JointEffortGoal::Builder out);
void write(const robots::JointConfiguration& value, wire::JointConfiguration::Builder out);
void write(const robots::Jacobian& value, wire::Jacobian::Builder out);
void write(const robots::Twist& value, wire::Twist::Builder out);
void write(const robots::TwistGoal& value, wire::TwistGoal::Builder out);
void write(const robots::Wrench& value, wire::Wrench::Builder out);
void write(const robots::WrenchGoal& value, wire::WrenchGoal::Builder out);
void write(const robots::CartesianState& value, wire::CartesianState::Builder out);
void write(const suture::Message& value, suture::wire::Message::Builder out);
void write(const robots::IntervalStatistics& value, wire::IntervalStatistics::Builder out);
void write(const robots::OperatingState& value, wire::OperatingState::Builder out);
wire::ArmState write(robots::ArmState value);

void read(wire::PoseStamped::Reader in, robots::PoseStamped& value);
void read(wire::TransformStamped::Reader in, robots::TransformStamped& value);
void read(wire::JointState::Reader in, robots::JointState& value);
void read(wire::JointGoal::Reader in, robots::JointGoal& value);
void read(wire::JointSolution::Reader in, robots::JointSolution& value);
void read(wire::JointVelocityGoal::Reader in, robots::JointVelocityGoal& value);
void read(wire::JointEffortGoal::Reader in, robots::JointEffortGoal& value);
void read(wire::JointConfiguration::Reader in, robots::JointConfiguration& value);
void read(wire::Jacobian::Reader in, robots::Jacobian& value);
void read(wire::Twist::Reader in, robots::Twist& value);
void read(wire::TwistGoal::Reader in, robots::TwistGoal& value);
void read(wire::Wrench::Reader in, robots::Wrench& value);
void read(wire::WrenchGoal::Reader in, robots::WrenchGoal& value);
void read(wire::CartesianState::Reader in, robots::CartesianState& value);
void read(suture::wire::Message::Reader in, suture::Message& value);
void read(wire::IntervalStatistics::Reader in, robots::IntervalStatistics& value);
void read(wire::OperatingState::Reader in, robots::OperatingState& value);
robots::ArmState read(wire::ArmState in);

/// Does the same as a new value.
template <class Value, class Reader>
Value as(Reader in) {
  Value value;
  read(in, value);
  return value;
}

}  // namespace handwritten
