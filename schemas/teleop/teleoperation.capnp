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
  # waits for both arms: connected, enabled, homed, fresh data of both, and a slave
  # that carries out goals
  following @2 $Meta.cxx("Following") $Meta.value(2);
  aligning @3 $Meta.cxx("Aligning") $Meta.value(3);
  # turns the master to the orientation that the slave has in the view
  clutched @4 $Meta.cxx("Clutched") $Meta.value(4);
  # the clutch is pressed, or nobody is at the console: the slave holds, the master is
  # the surgeon's to move
}

struct FollowAnchors @0x8cdd0eb841f978ce $Meta.cxx("robots::FollowAnchors") {
  # Says where following began: with this and the master's poses, anyone can compute what the slave
  # should do.

  masterStamp @0 :Int64 $Meta.clock("steady") $Meta.cxx("master_stamp");
  # The first master pose that was followed has this stamp.
  master @1 :Types.Pose $Meta.unit("m");
  # The master's measured pose was this at that stamp, in the master's reference frame.
  slaveSetpoint @2 :Types.Pose $Meta.cxx("slave_setpoint") $Meta.unit("m");
  # The slave's set-point was this at entry, in the slave's reference frame.
  scale @3 :Float64;
  # The slave moves this many metres for each metre of the master.
  entry @4 :UInt64;
  # Following began this many times, including this one; 0 if it never did. A change of the
  # settings counts too, and does not move the slave.
  view @5 :Types.Mat3;
  # Rotates directions of the master's reference frame to those of the slave's that look the same
  # to the surgeon.
  rotationLocked @6 :Bool $Meta.cxx("rotation_locked");
  translationLocked @7 :Bool $Meta.cxx("translation_locked");
}

interface Teleoperation @0x9c2044876661808e $Meta.cxx("robots::Teleoperation") {
  # Commands run in the teleoperation's own thread before its next cycle. A change of the settings
  # while it follows does not move the slave: it follows from where it is.

  subscribe @0 (events :TeleoperationEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  enable @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Enables and homes arms that are not, then follows. It does not enable an arm in FAULT: the
  # operator who has removed the cause does.
  disable @2 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops following. The slave holds.
  teleopState @3 (sent :Rpc.Sent) -> (value :TeleopState, stamp :Int64) $Meta.cxx("teleop_state")
      $Meta.kind("read");
  anchors @4 (sent :Rpc.Sent) -> (value :FollowAnchors, stamp :Int64) $Meta.kind("read");
  # Returns the anchors of the present or last time of following.
  setScale @5 (scale :Float64 $Meta.range(lowest = 0.01, highest = 10), sent :Rpc.Sent) -> ()
      $Meta.cxx("set_scale") $Meta.kind("write") $Meta.queue(16);
  lockRotation @6 (lock :Bool, sent :Rpc.Sent) -> () $Meta.cxx("lock_rotation") $Meta.kind("write")
      $Meta.queue(16);
  # Makes the slave keep its orientation. When it is unlocked, the master is aligned anew before
  # the slave follows.
  lockTranslation @7 (lock :Bool, sent :Rpc.Sent) -> () $Meta.cxx("lock_translation")
      $Meta.kind("write") $Meta.queue(16);
  # Makes the slave keep its position.
  settings @8 (sent :Rpc.Sent) -> (value :TeleopSettings, stamp :Int64) $Meta.kind("read");
}

interface TeleoperationEvents @0xe8de6e374cc63239 $Meta.eventsOf("robots::Teleoperation") {
  # What a subscriber of Teleoperation receives.

  state @0 (row :TeleoperationStateRow) -> ();
  # A new row of the columns asked for.
  teleopState @1 (value :TeleopState, stamp :Int64) -> () $Meta.cxx("teleop_state") $Meta.latched
      $Meta.queue(16);
  followed @2 (value :FollowAnchors, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that following begins, or goes on with other settings.
  settings @3 (value :TeleopSettings, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports each change, and the last one to a client that connects.
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
  settings @5 :TeleopSettings;
}

struct TeleopSettings @0xe1eab6cf5390e93b $Meta.cxx("robots::TeleopSettings") {
  # Holds the settings by which the slave follows.

  scale @0 :Float64;
  # The slave moves this many metres for each metre of the master.
  rotationLocked @1 :Bool $Meta.cxx("rotation_locked");
  translationLocked @2 :Bool $Meta.cxx("translation_locked");
}
