@0xf3cceb9985533115;
# The wire contract of arm_control/mtm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Side = import "/robot_types/side.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm_control/mtm.h");

enum MtmSide @0xbfac2efab040ce66 $Meta.cxx("robots::MtmSide") $Meta.removed("MtmSide")
    $Meta.underlying("UInt8") {
  left @0 $Meta.cxx("Left") $Meta.value(0);
  right @1 $Meta.cxx("Right") $Meta.value(1);
}

struct MtmParameters @0x82e61784da147f11 $Meta.cxx("robots::MtmParameters") {
  side @0 :Side.Side;
  period @1 :Int64 = 1000000 $Meta.period("1/1000000000");
  angularRate @2 :Float64 = 4.0 $Meta.cxx("angular_rate") $Meta.range(lowest = 0.01, highest = 20)
      $Meta.unit("rad/s");
  followingError @3 :Float64 = 0.8 $Meta.cxx("following_error")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("rad");
  # A rotating joint that trails its set-point by more than this faults the arm. At these rates a
  # servo goal may lie 0.4 rad ahead of the set-point (servo_horizon), and the joints trail the
  # set-point by rate x time constant. Goals that run further ahead of the joints fault the arm,
  # though each is near the one before.
  servoHorizon @4 :Float64 = 0.1 $Meta.cxx("servo_horizon")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("s");
  # A servo goal may lie as far from the set-point as the joints can move in this time at their
  # rate limits; one that lies farther is refused. By default this is as long as a stream may be
  # silent: what the master does in 0.1 s is far below the rates of the slave. It must be so short
  # that this is less than the following error of each joint.
  gripperClosed @5 :Float64 $Meta.cxx("gripper_closed") $Meta.range(lowest = -0.2, highest = 1.05)
      $Meta.unit("rad");
  # At this angle or less the gripper is closed.
  gripperDebounce @6 :Float64 = 0.02 $Meta.cxx("gripper_debounce")
      $Meta.range(lowest = 0, highest = 1) $Meta.unit("s");
  # The gripper must be closed, or open, for this long before that is reported.
  jumpFactor @7 :Float64 = 5.0 $Meta.cxx("jump_factor") $Meta.range(lowest = 1, highest = 1000);
  # A joint whose encoder measures a motion of more than this many times what the joint can do
  # faults the arm.
  overloadTime @8 :Float64 = 0.1 $Meta.cxx("overload_time")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("s");
  # An effort that is above what the joint may take for longer than this faults the arm too.
  angularAcceleration @9 :Float64 = 40.0 $Meta.cxx("angular_acceleration")
      $Meta.range(lowest = 0.1, highest = 1000) $Meta.unit("rad/s2");
  # The joints may speed up and slow down this fast in a move. Nothing is published of what they
  # can do, so this is our own. The da Vinci Research Kit's moves keep to 0.785 rad/s2, the roll's
  # to 6.28 (mtsIntuitiveResearchKitMTM.cpp: m_trajectory_j.a_max).
}
