@0xc846eefb33b1e6ac;
# The wire contract of robots/arm.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Geometry = import "/robots/geometry.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robots/arm.h");

enum Mode @0xab8c3dd92b2643d4 $Meta.cxx("robots::Mode") $Meta.underlying("Int8") {
  # What the arm does.

  disabled @0 $Meta.cxx("Disabled") $Meta.value(-1);
  holdStill @1 $Meta.cxx("HoldStill") $Meta.value(4);
  # Brakes off, set-point frozen.
  servo @2 $Meta.cxx("Servo") $Meta.value(2);
}

struct Everything @0xe827b555e2bdb416 $Meta.cxx("robots::Everything") {
  # Every kind of member.
  #
  # Two paragraphs.

  on @0 :Bool;
  tiny @1 :Int8;
  count @2 :UInt64;
  speed @3 :Float64 = 0.25 $Meta.range(lowest = -0.5, highest = 2) $Meta.unit("m/s");
  # Along the path.
  ratio @4 :Float32;
  mode @5 :Mode = servo;
  label @6 :Text $Meta.capacity([16]);
  bytes @7 :Data $Meta.capacity([32]);
  flags @8 :List(Bool) $Meta.capacity([4]);
  names @9 :List(Text) $Meta.capacity([3, 8]);
  pairs @10 :List(List(Float64)) $Meta.capacity([5]) $Meta.shape("*,2");
  modes @11 :List(Mode) $Meta.shape("2");
  goal @12 :Geometry.PoseStamped;
  track @13 :List(Geometry.PoseStamped) $Meta.capacity([2]);
  point @14 :Types.Vec3 $Meta.unit("m");
  plane @15 :List(Float32) $Meta.shape("3x1");
  inertia @16 :Types.Mat3;
  jacobian @17 :List(Float64) $Meta.shape("6x7");
  attitude @18 :Types.Quat;
  period @19 :Int64 $Meta.period("1/1000");
  when @20 :Int64 $Meta.clock("steady");
}

interface Arm @0x974e120931408f6d $Meta.cxx("robots::Arm") {
  # A robot arm.

  subscribe @0 (events :ArmEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  enable @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(4);
  servoCp @2 (goal :Geometry.PoseStamped, sent :Rpc.Sent) -> () $Meta.cxx("servo_cp")
      $Meta.kind("write") $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Follow the goal.
  setSpeed @3 (speed :Float64 $Meta.unit("m/s"), sent :Rpc.Sent) -> () $Meta.cxx("set_speed")
      $Meta.kind("write") $Meta.queue(16);
  measuredCp @4 (sent :Rpc.Sent) -> (value :Geometry.PoseStamped, stamp :Int64)
      $Meta.cxx("measured_cp") $Meta.kind("read");
  mode @5 (sent :Rpc.Sent) -> (value :Mode, stamp :Int64) $Meta.kind("read");
  everything @6 (sent :Rpc.Sent) -> (value :Everything, stamp :Int64) $Meta.kind("read");
  inverseKinematics @7 (x :Geometry.PoseStamped, tolerance :Float64 $Meta.range(lowest = 0, highest = 1), sent :Rpc.Sent) -> (value :Everything)
      $Meta.cxx("inverse_kinematics") $Meta.kind("qualifiedRead");
  grasp @8 (width :Float64, mode :Mode, sent :Rpc.Sent) -> (value :Bool) $Meta.deadline(50000000)
      $Meta.kind("writeReturn") $Meta.queue(2);
  # Closes the gripper; answers whether it holds something.
  nextToken @9 (sent :Rpc.Sent) -> (value :UInt32) $Meta.cxx("next_token") $Meta.kind("voidReturn")
      $Meta.queue(16) $Meta.since(1);
  park @10 (sent :Rpc.Sent) -> () $Meta.deprecated("use enable") $Meta.direct $Meta.kind("void")
      $Meta.optional $Meta.queue(16);
  load @11 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read") $Meta.optional;
}

interface ArmEvents @0xa6aa5daf71e0a4ba $Meta.eventsOf("robots::Arm") {
  # What a subscriber of Arm receives.

  state @0 (row :ArmStateRow) -> ();
  # A new row of the columns asked for.
  modeChanged @1 (value :Mode, stamp :Int64) -> () $Meta.cxx("mode_changed") $Meta.latched
      $Meta.queue(8);
  stopped @2 (stamp :Int64) -> () $Meta.queue(16);
  arrived @3 (value :Geometry.PoseStamped, stamp :Int64) -> () $Meta.queue(16);
  moved @4 (value :Geometry.PoseStamped, value2 :Float64, value3 :Mode, stamp :Int64) -> ()
      $Meta.latched $Meta.queue(16);
  # Where, how fast and why.
}

struct ArmStateRow @0xd633b378dcab35c1 $Meta.stateOf("robots::Arm") {
  # One row of the state table: what the read commands of Arm answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  measuredCp @3 :Geometry.PoseStamped $Meta.cxx("measured_cp");
  mode @4 :Mode;
  everything @5 :Everything;
  load @6 :Float64 $Meta.optional;
}
