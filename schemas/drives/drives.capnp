@0xed5bfd1260b9675a;
# The wire contract of drives/drives.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("drives/drives.h");

enum DrivePower @0xd2f9073be1a76833 $Meta.cxx("robots::DrivePower") $Meta.underlying("UInt8") {
  notReady @0 $Meta.cxx("NotReady") $Meta.value(0);
  # since they started, nobody has permitted them power
  stopped @1 $Meta.cxx("Stopped") $Meta.value(1);
  # by the emergency stop, or because nobody permits power any more
  off @2 $Meta.cxx("Off") $Meta.value(2);
  # without power, which they are permitted to have: what brakes they have are on
  on @3 $Meta.cxx("On") $Meta.value(3);
  # the joints follow their goals
}

struct DriveFeedback @0xc6e6797127c781ed $Meta.cxx("robots::DriveFeedback") {
  # A DriveFeedback is what the drives measure in each of their cycles. It is of actuators, in the
  # order of the joints of the chain, and of the tool behind them: a slave's jaw, or a master's
  # gripper, which nothing drives. coupling.h says how the actuators of an arm turn its joints; most
  # are their joint. The actuator of a prismatic joint has m, m/s and N.

  position @0 :List(Float64) $Meta.shape("8") $Meta.unit("rad");
  # The first `joints` entries count.
  velocity @1 :List(Float64) $Meta.shape("8") $Meta.unit("rad/s");
  joints @2 :UInt32;
  power @3 :DrivePower;
  permitted @4 :Int64 $Meta.clock("steady");
  # They were last permitted to have power at this time. If this changes, they have stopped
  # meanwhile, or are other drives, which an arm may not have seen.
  stamp @5 :Int64 $Meta.clock("steady");
  # The stamp is that of the drives' cycle.
  effort @6 :List(Float64) $Meta.shape("8") $Meta.unit("N.m");
  # The motors give these efforts, as their currents show them.
  measuresEffort @7 :Bool $Meta.cxx("measures_effort");
  # This is true if `effort` is measured. Joints that are simulated without mass need none, and
  # have 0; so does a simulated jaw, which has no mass whatever this says.
  controlsEffort @8 :Bool $Meta.cxx("controls_effort");
  # This is true if the drives obey what a goal says beside positions. Joints that are simulated
  # without mass have no effort, so their drives follow positions only.
}

struct DriveGoal @0xe3033c33c5a1f822 $Meta.cxx("robots::DriveGoal") {
  # Says where the actuators shall be, in the same order, and what their motors do beside that. The
  # entry of a gripper has no effect.

  position @0 :List(Float64) $Meta.shape("8") $Meta.unit("rad");
  # The first `joints` entries count.
  joints @1 :UInt32;
  effort @2 :List(Float64) $Meta.shape("8") $Meta.unit("N.m");
  # The motors give this beside what holds the joints and carries the arm. All together is cut to
  # what a motor can give.
  released @3 :List(Bool) $Meta.shape("8");
  # There is an entry for each joint of the chain, not for each actuator. A joint for which it is
  # true is not held: its position here has no effect. At more than its rate limit it is slowed
  # down.
  gravityCompensation @4 :Bool = true $Meta.cxx("gravity_compensation");
  # If it is true, the motors carry the arm's weight. It counts until the next goal, also after
  # the stream has ended.
}

interface Drives @0x91efda82df1adc01 $Meta.cxx("robots::Drives") {
  # Commands run in the drives' own thread before its next cycle; the read is from the end of its
  # last one.

  subscribe @0 (events :DrivesEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  powerOn @1 (permitted :Int64 $Meta.clock("steady"), sent :Rpc.Sent) -> () $Meta.cxx("power_on")
      $Meta.kind("write") $Meta.queue(16);
  # Releases the brakes. The joints hold where they are. `permitted` is that of the feedback that
  # this answers: drives that have stopped since then, or may not have power, stay as they are.
  powerOff @2 (sent :Rpc.Sent) -> () $Meta.cxx("power_off") $Meta.kind("void") $Meta.queue(16);
  # Lets the brakes hold the joints where they are. The joints of an arm that has none sink by
  # their weight.
  servoJp @3 (goal :DriveGoal, sent :Rpc.Sent) -> () $Meta.cxx("servo_jp") $Meta.kind("write")
      $Meta.latest $Meta.queue(16) $Meta.ttl(20000000);
  # Streams goals, newest wins. Without power, or with the wrong number of joints, a goal changes
  # nothing. A stream that falls silent for 0.1 s leaves the joints where they are: they are held
  # there, and no effort of a goal acts any more.
  feedback @4 (sent :Rpc.Sent) -> (value :DriveFeedback, stamp :Int64) $Meta.kind("read");
}

interface DrivesEvents @0xe59a5d931070aa84 $Meta.eventsOf("robots::Drives") {
  # What a subscriber of Drives receives.

  state @0 (row :DrivesStateRow) -> ();
  # A new row of the columns asked for.
  power @1 (value :DrivePower, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports each change, and the last one to a client that connects.
}

struct DrivesStateRow @0xf51328c4223872e4 $Meta.stateOf("robots::Drives") {
  # One row of the state table: what the read commands of Drives answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  feedback @3 :DriveFeedback;
}
