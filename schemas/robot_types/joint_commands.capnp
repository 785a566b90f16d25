@0xd2e575853e8af34a;
# The wire contract of robot_types/joint_commands.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/joint_commands.h");

enum JointType @0x9f3bef15df1181c0 $Meta.cxx("robots::JointType") $Meta.underlying("UInt8") {
  undefined @0 $Meta.cxx("Undefined") $Meta.value(0);
  prismatic @1 $Meta.cxx("Prismatic") $Meta.value(1);
  revolute @2 $Meta.cxx("Revolute") $Meta.value(2);
  universal @3 $Meta.cxx("Universal") $Meta.value(3);
  ballSocket @4 $Meta.cxx("BallSocket") $Meta.value(4);
  inactive @5 $Meta.cxx("Inactive") $Meta.value(5);
}

struct JointPosition @0x8d40d571bf8db891 $Meta.cxx("robots::JointPosition") {
  # Corresponds to cisst's prmPositionJointGet.

  position @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  stamps @1 :List(Int64) $Meta.capacity([8]) $Meta.clock("steady");
  # Say when each joint was read.
  stamp @2 :Int64 $Meta.clock("steady");
  valid @3 :Bool;
}

struct JointPositionGoal @0xcc0da9976c58b05d $Meta.cxx("robots::JointPositionGoal") {
  # Corresponds to cisst's prmPositionJointSet.

  goal @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  velocity @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s");
  # The list may be empty.
  acceleration @2 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s2");
  # The list may be empty.
  timeLimit @3 :Int64 $Meta.cxx("time_limit") $Meta.period("1/1000000000");
  # There is no limit if it is 0.
  isCoordinated @4 :Bool = true $Meta.cxx("is_coordinated");
  # If it is true, all joints arrive together.
  stamp @5 :Int64 $Meta.clock("steady");
}

struct JointVelocity @0xeb6eb36387c53fe2 $Meta.cxx("robots::JointVelocity") {
  # Corresponds to cisst's prmVelocityJointGet.

  velocity @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s");
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}

struct JointVelocityGoal @0xf166e3d075579061 $Meta.cxx("robots::JointVelocityGoal") {
  # A JointVelocityGoal is the goal of CRTK's servo_jv; corresponds to cisst's prmVelocityJointSet.

  goal @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s");
  acceleration @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s2");
  # The list may be empty.
  deceleration @2 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s2");
  # The list may be empty.
  guard @3 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  # The joints shall not pass these positions; the list may be empty.
  mask @4 :List(Bool) $Meta.capacity([8]);
  # The mask says which joints count; if it is empty, all do.
  stamp @5 :Int64 $Meta.clock("steady");
}

struct JointEffortGoal @0xd704fc0995280ce6 $Meta.cxx("robots::JointEffortGoal") {
  # A JointEffortGoal is the goal of CRTK's servo_jf; corresponds to cisst's prmForceTorqueJointSet.

  effort @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("N.m");
  mask @1 :List(Bool) $Meta.capacity([8]);
  # The mask says which joints count; if it is empty, all do.
  stamp @2 :Int64 $Meta.clock("steady");
}

struct JointConfiguration @0xf723b5ed0dc2d63c $Meta.cxx("robots::JointConfiguration") {
  # Says what the joints are and what they may do, for CRTK's configuration_js. Corresponds to
  # cisst's prmConfigurationJoint.

  name @0 :List(Text) $Meta.capacity([8, 15]);
  type @1 :List(JointType) $Meta.capacity([8]);
  positionMin @2 :List(Float64) $Meta.capacity([8]) $Meta.cxx("position_min") $Meta.unit("rad");
  positionMax @3 :List(Float64) $Meta.capacity([8]) $Meta.cxx("position_max") $Meta.unit("rad");
  velocityMin @4 :List(Float64) $Meta.capacity([8]) $Meta.cxx("velocity_min") $Meta.unit("rad/s");
  velocityMax @5 :List(Float64) $Meta.capacity([8]) $Meta.cxx("velocity_max") $Meta.unit("rad/s");
  accelerationMin @6 :List(Float64) $Meta.capacity([8]) $Meta.cxx("acceleration_min")
      $Meta.unit("rad/s2");
  accelerationMax @7 :List(Float64) $Meta.capacity([8]) $Meta.cxx("acceleration_max")
      $Meta.unit("rad/s2");
  effortMin @8 :List(Float64) $Meta.capacity([8]) $Meta.cxx("effort_min") $Meta.unit("N.m");
  effortMax @9 :List(Float64) $Meta.capacity([8]) $Meta.cxx("effort_max") $Meta.unit("N.m");
  valid @10 :Bool;
}

struct ServoJoint @0xf49c2efeb3512c06 $Meta.cxx("robots::ServoJoint") {
  # A ServoJoint has position, velocity and effort in one servo command; corresponds to cisst's
  # prmServoJoint.

  name @0 :List(Text) $Meta.capacity([8, 15]);
  mode @1 :List(UInt16) $Meta.capacity([8]);
  # Each joint has these bits: 1 position, 2 velocity, 4 effort.
  position @2 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  velocity @3 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s");
  effort @4 :List(Float64) $Meta.capacity([8]) $Meta.unit("N.m");
  positionProjection @5 :List(Float64) $Meta.capacity([64]) $Meta.cxx("position_projection");
  # Says what position control may act on; row-major, joints x joints.
  stamp @6 :Int64 $Meta.clock("steady");
}

struct ActuatorJointCoupling @0xc217034d474a2284 $Meta.cxx("robots::ActuatorJointCoupling") {
  # Turns actuators into joints and back, joints x actuators, row-major.
  # Corresponds to cisst's prmActuatorJointCoupling.

  joints @0 :UInt32;
  actuators @1 :UInt32;
  actuatorToJointPosition @2 :List(Float64) $Meta.capacity([64])
      $Meta.cxx("actuator_to_joint_position");
  jointToActuatorPosition @3 :List(Float64) $Meta.capacity([64])
      $Meta.cxx("joint_to_actuator_position");
  actuatorToJointEffort @4 :List(Float64) $Meta.capacity([64])
      $Meta.cxx("actuator_to_joint_effort");
  jointToActuatorEffort @5 :List(Float64) $Meta.capacity([64])
      $Meta.cxx("joint_to_actuator_effort");
}

struct Jacobian @0x9172ad0b0a6919ab $Meta.cxx("robots::Jacobian") {
  # A Jacobian is 6 x joints, column-major: linear rows first, in m/s and rad/s per unit of joint
  # velocity.

  joints @0 :UInt32;
  coefficients @1 :List(Float64) $Meta.capacity([48]);
  stamp @2 :Int64 $Meta.clock("steady");
  valid @3 :Bool;
}
