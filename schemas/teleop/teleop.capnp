@0xa6f662633b91810f;
# The wire contract of teleop/teleop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Side = import "/robot_types/side.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("teleop/teleop.h");

struct TeleopParameters @0xd4e01364c600f6cf $Meta.cxx("robots::TeleopParameters") {
  period @0 :Int64 $Meta.default("1000000") $Meta.period("1/1000000000");
  scale @1 :Float64 = 0.2 $Meta.range(lowest = 0.01, highest = 10);
  # The slave moves this many metres for each metre of the master.
  maxAge @2 :Int64 $Meta.cxx("max_age") $Meta.default("20000000") $Meta.period("1/1000000000");
  # With data older than this following ends, and begins anew when they are fresh again.
  enableAtStart @3 :Bool = true $Meta.cxx("enable_at_start");
  # If it is true, the task prepares and follows without waiting for enable().
  align @4 :Bool = true;
  # If it is true, the master is turned to the orientation of the slave before the slave follows.
  # If not, the difference between them stays.
  alignmentTolerance @5 :Float64 = 0.087 $Meta.cxx("alignment_tolerance")
      $Meta.range(lowest = 0.001, highest = 1) $Meta.unit("rad");
  # A difference of at most this counts as none, and stays.
  preparationLimit @6 :Int64 = 60000000000 $Meta.cxx("preparation_limit")
      $Meta.period("1/1000000000");
  # If the arms are not ready, or the master is not aligned, after this time, the teleoperation is
  # disabled. With 0 it waits for ever.
  operatorAge @7 :Int64 = 200000000 $Meta.cxx("operator_age") $Meta.period("1/1000000000");
  # If pedals or presence are older than this, they are not known, which ends following.
  masterSide @8 :Side.Side $Meta.cxx("master_side");
  # Say which arms of the registration these are.
  slaveSide @9 :Side.Side $Meta.cxx("slave_side");
  jawScale @10 :Float64 = 1.3333 $Meta.cxx("jaw_scale") $Meta.range(lowest = 0.01, highest = 10);
  # The jaw turns this many radians for each radian of the gripper, from this angle with the
  # gripper at 0: 60 degrees of the gripper are the 80 of the jaw.
  jawOffset @11 :Float64 $Meta.cxx("jaw_offset") $Meta.range(lowest = -2, highest = 2)
      $Meta.unit("rad");
  jawRate @12 :Float64 = 12.566 $Meta.cxx("jaw_rate") $Meta.range(lowest = 0.01, highest = 50)
      $Meta.unit("rad/s");
  # The jaw follows this fast, and goes this fast to where the gripper is before that.
  jawGhostRate @13 :Float64 = 0.6283 $Meta.cxx("jaw_ghost_rate")
      $Meta.range(lowest = 0.01, highest = 50) $Meta.unit("rad/s");
  jawTolerance @14 :Float64 = 0.0349 $Meta.cxx("jaw_tolerance")
      $Meta.range(lowest = 0.001, highest = 1) $Meta.unit("rad");
  # When the jaw is this near to where the gripper is, it follows.
  registrationAge @15 :Int64 = 250000000 $Meta.cxx("registration_age") $Meta.period("1/1000000000");
  # Following does not begin with a registration that was renewed longer ago than this. It goes on
  # with the one with which it began.
  releaseMaster @16 :Bool $Meta.cxx("release_master");
  # If it is true, the master's motors only carry it while it is the surgeon's to move, which is
  # while the slave follows and while a pedal is pressed, and hold it otherwise. A master that
  # gets goals from another client, such as a simulated surgeon, needs false: it moves by those.
}
