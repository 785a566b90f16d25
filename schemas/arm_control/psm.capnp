@0xca592706d4e30bc3;
# The wire contract of arm_control/psm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm_control/psm.h");

struct PsmParameters @0x9dae68576e1e4769 $Meta.cxx("robots::PsmParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  angularRate @1 :Float64 = 4.0 $Meta.cxx("angular_rate") $Meta.range(lowest = 0.01, highest = 20)
      $Meta.unit("rad/s");
  # The rotating joints move at this rate at most.
  followingError @2 :Float64 = 0.8 $Meta.cxx("following_error")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("rad");
  # A rotating joint that trails its set-point by more than this faults the arm. One servo goal
  # may lie 0.4 rad ahead of the set-point at these rates (servo_horizon), behind which the joints
  # trail by rate x time constant already. Goals that run ahead of the joints by more fault the
  # arm, though each is near the one before.
  insertionRate @3 :Float64 = 0.4 $Meta.cxx("insertion_rate")
      $Meta.range(lowest = 0.001, highest = 2) $Meta.unit("m/s");
  # The insertion moves at this rate at most.
  insertionFollowingError @4 :Float64 = 0.08 $Meta.cxx("insertion_following_error")
      $Meta.range(lowest = 1e-04, highest = 1) $Meta.unit("m");
  # The same bound holds for the insertion.
  servoHorizon @5 :Float64 = 0.1 $Meta.cxx("servo_horizon")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("s");
  # A servo goal may lie as far from the set-point as the joints can move in this time at their
  # rate limits; one that lies farther is refused. By default this is as long as a stream may be
  # silent: what the master does in 0.1 s is far below the rates of the slave. It must be so short
  # that this is less than the following error of each joint.
  jawRate @6 :Float64 = 12.566 $Meta.cxx("jaw_rate") $Meta.range(lowest = 0.01, highest = 50)
      $Meta.unit("rad/s");
  # The jaw moves at this rate at most; by default at that of the da Vinci Research Kit's
  # teleoperation.
  jumpFactor @7 :Float64 = 5.0 $Meta.cxx("jump_factor") $Meta.range(lowest = 1, highest = 1000);
  # A joint whose encoder measures a motion of more than this many times what the joint can do
  # faults the arm.
  overloadTime @8 :Float64 = 0.1 $Meta.cxx("overload_time")
      $Meta.range(lowest = 0.001, highest = 10) $Meta.unit("s");
  # An effort that is above what the joint may take for longer than this faults the arm too.
  angularAcceleration @9 :Float64 = 40.0 $Meta.cxx("angular_acceleration")
      $Meta.range(lowest = 0.1, highest = 1000) $Meta.unit("rad/s2");
  # The rotating joints may speed up and slow down this fast in a move. Nothing is published of
  # what the joints can do, so this is our own, as are the two below.
  insertionAcceleration @10 :Float64 = 4.0 $Meta.cxx("insertion_acceleration")
      $Meta.range(lowest = 0.01, highest = 100) $Meta.unit("m/s2");
  # This says the same of the insertion.
  jawAcceleration @11 :Float64 = 200.0 $Meta.cxx("jaw_acceleration")
      $Meta.range(lowest = 0.1, highest = 10000) $Meta.unit("rad/s2");
  # This says the same of the jaw.
  homeInsertion @12 :Float64 = 0.12 $Meta.cxx("home_insertion")
      $Meta.range(lowest = 0, highest = 0.24) $Meta.unit("m");
  # home() inserts the instrument this deep. Cartesian control needs 0.063 m: then the wrist is 47
  # mm beyond the remote centre.
}
