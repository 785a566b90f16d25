@0xd901efa22b56ccad;
# The wire contract of teleop/teleoperation.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("teleop/teleoperation.h");

enum TeleopState @0x82c72c556eb58a10 $Meta.cxx("robots::TeleopState") $Meta.underlying("UInt8") {
  disabled @0 $Meta.cxx("Disabled") $Meta.value(0);
  # until enable()
  preparing @1 $Meta.cxx("Preparing") $Meta.value(1);
  # waits for both arms: connected, enabled, homed, and fresh data of both
  following @2 $Meta.cxx("Following") $Meta.value(2);
}

struct FollowAnchors @0x8cdd0eb841f978ce $Meta.cxx("robots::FollowAnchors") {
  # Where following began: with it and the master's poses, anyone can compute what the slave should
  # do.

  masterStamp @0 :Int64 $Meta.clock("steady") $Meta.cxx("master_stamp");
  # Stamp of the first master pose that was followed.
  master @1 :Types.Pose $Meta.unit("m");
  # The master's measured pose at that stamp, in the master's base frame.
  slaveSetpoint @2 :Types.Pose $Meta.cxx("slave_setpoint") $Meta.unit("m");
  # The slave's set-point at entry, in the slave's base frame.
  scale @3 :Float64;
  # Slave metres a master metre.
  entry @4 :UInt64;
  # How many times following began, this one included; 0: never.
}

interface Teleoperation @0x9c2044876661808e $Meta.cxx("robots::Teleoperation") {
  subscribe @0 (events :TeleoperationEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  enable @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Enables and homes arms that are not, then follows.
  disable @2 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops following; the slave holds.
  teleopState @3 (sent :Rpc.Sent) -> (value :TeleopState, stamp :Int64) $Meta.cxx("teleop_state")
      $Meta.kind("read");
  anchors @4 (sent :Rpc.Sent) -> (value :FollowAnchors, stamp :Int64) $Meta.kind("read");
  # Of the present or last time of following.
}

interface TeleoperationEvents @0xe8de6e374cc63239 $Meta.eventsOf("robots::Teleoperation") {
  # What a subscriber of Teleoperation receives.

  state @0 (row :TeleoperationStateRow) -> ();
  # A new row of the columns asked for.
  teleopState @1 (value :TeleopState) -> () $Meta.cxx("teleop_state") $Meta.latched $Meta.queue(16);
  followed @2 (value :FollowAnchors) -> () $Meta.latched $Meta.queue(16);
  # Following begins.
}

struct TeleoperationStateRow @0xbc0e291de17cadad $Meta.stateOf("robots::Teleoperation") {
  # One row of the state table: what the read commands of Teleoperation answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  teleopState @2 :TeleopState $Meta.cxx("teleop_state");
  anchors @3 :FollowAnchors;
  tooLarge @4 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
