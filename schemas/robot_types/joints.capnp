@0xd6150fc06cd30044;
# The wire contract of robot_types/joints.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/joints.h");

struct JointState @0xac24dfe518a4963f $Meta.cxx("robots::JointState") {
  # A JointState is the state of all joints of an arm, in chain order: CRTK's measured_js and
  # setpoint_js. A list is empty if its quantity is not known, and as long as `name` otherwise.

  name @0 :List(Text) $Meta.capacity([8, 15]);
  position @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  velocity @2 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad/s");
  effort @3 :List(Float64) $Meta.capacity([8]) $Meta.unit("N.m");
  stamp @4 :Int64 $Meta.clock("steady");
  valid @5 :Bool;
  # If it is false, do not use the state.
}

struct JointGoal @0x8943f2eac122865a $Meta.cxx("robots::JointGoal") {
  # Says where joints shall go: CRTK's servo_jp and move_jp.

  position @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  # There is one entry for each joint, in chain order.
  stamp @1 :Int64 $Meta.clock("steady");
}

struct JointSolution @0x871d0a082eb81ee3 $Meta.cxx("robots::JointSolution") {
  # A JointSolution is a joint vector that an arm computed, without heap so that a control loop may
  # return it.

  position @0 :List(Float64) $Meta.shape("8") $Meta.unit("rad");
  # The first `joints` entries count.
  joints @1 :UInt32;
  found @2 :Bool;
  # If it is false, no joint vector within limits reaches the pose, and `position` is the nearest
  # one found.
}
