@0xc9ef694ddfd3190f;
# The wire contract of 04_contract_and_loss/joystick.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("following::wire");
$Meta.header("04_contract_and_loss/joystick.h");

interface Joystick @0xba57d83dcf98cd85 $Meta.cxx("following::Joystick") {
  subscribe @0 (events :JoystickEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  angle @1 (sent :Rpc.Sent) -> (value :Float64 $Meta.unit("rad"), stamp :Int64) $Meta.kind("read");
  # Says how far the stick is turned.
}

interface JoystickEvents @0xbca1b09e26acd380 $Meta.eventsOf("following::Joystick") {
  # What a subscriber of Joystick receives.

  state @0 (row :JoystickStateRow) -> ();
  # A new row of the columns asked for.
}

struct JoystickStateRow @0xddcb191d942f6b5f $Meta.stateOf("following::Joystick") {
  # One row of the state table: what the read commands of Joystick answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  angle @3 :Float64 $Meta.unit("rad");
}
