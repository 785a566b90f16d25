@0x8e9b10c9db20d7b2;
# The wire contract of coordinator/emergency_stop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("coordinator/emergency_stop.h");

struct Permit @0xd02fe436dab69cbc $Meta.cxx("robots::Permit") {
  # Lets drives have power. It counts only as long as it is fresh, so that drives that do not
  # receive it any more stop too.

  granted @0 :Bool;
  stamp @1 :Int64 $Meta.clock("steady");
  # The coordinator renewed it in the cycle of this stamp.
  press @2 :UInt64;
  # The number of the last press is also in StopNews::press.
}

struct StopNews @0xcd5512b8a090183f $Meta.cxx("robots::StopNews") {
  # Says that the emergency stop was pressed, or released.

  pressed @0 :Bool;
  stamp @1 :Int64 $Meta.clock("steady");
  isStart @2 :Bool $Meta.cxx("is_start");
  # This is true if nobody has pressed it: the coordinator has just started, and starts pressed.
  press @3 :UInt64;
  # Identifies the last press, and so does release(). No two presses have the same one, nor has
  # one of a coordinator that ran before.
}

interface EmergencyStop @0x85a101cfc49eccfc $Meta.cxx("robots::EmergencyStop") $Meta.major(2)
    $Meta.version(2) {
  # Commands run in the coordinator's thread before its next cycle.

  subscribe @0 (events :EmergencyStopEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  press @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Stops all drives. None has power until release().
  release @2 (sent :Rpc.Sent, press :UInt64) -> () $Meta.kind("write") $Meta.queue(16);
  # Lets drives have power again, which an operator must have decided. `press` is that of the news
  # that this answers: it does nothing if somebody has pressed since. Arms stay disabled until
  # somebody enables them, such as a console that brings its system up by itself.
  permit @3 (sent :Rpc.Sent) -> (value :Permit, stamp :Int64) $Meta.kind("read");
  # The coordinator renews the permit in each cycle.
}

interface EmergencyStopEvents @0xd5baa187cf46a24d $Meta.eventsOf("robots::EmergencyStop") {
  # What a subscriber of EmergencyStop receives.

  state @0 (row :EmergencyStopStateRow) -> ();
  # A new row of the columns asked for.
  stop @1 (value :StopNews, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports each press and each release, and the last one to a client that connects.
}

struct EmergencyStopStateRow @0xf44715265e64d420 $Meta.stateOf("robots::EmergencyStop") {
  # One row of the state table: what the read commands of EmergencyStop answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  permit @3 :Permit;
}
