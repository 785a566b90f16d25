@0xe0cf7df960586c1f;
# The wire contract of console/console.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Messages = import "/suture/standard/messages.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("console/console.h");

enum ConsoleState @0xe5858b1b3b511bbf $Meta.cxx("robots::ConsoleState") $Meta.underlying("UInt8") {
  down @0 $Meta.cxx("Down") $Meta.value(0);
  # until bring_up()
  enabling @1 $Meta.cxx("Enabling") $Meta.value(1);
  # the arms get power, one after the other
  homing @2 $Meta.cxx("Homing") $Meta.value(2);
  # they move to their home positions
  up @3 $Meta.cxx("Up") $Meta.value(3);
  # the arms are ready, and what moves them is enabled
  incomplete @4 $Meta.cxx("Incomplete") $Meta.value(4);
  # it was up, and a part is missing or not ready; up again when all are
  leaving @5 $Meta.cxx("Leaving") $Meta.value(5);
  # bring_down() is under way, or a bring-up that failed is taken back
}

interface Console @0xdf92213fbec2997e extends(Messages.Messages) $Meta.cxx("robots::Console") {
  # Commands run in the console's own thread before its next cycle. Status, warning and error are
  # the standard messages: they say what is missing, and which part did not do what it was asked. A
  # warning with the code of ArmWarning::PowerLost (arm/arm_warning.h) names an arm whose drives
  # have lost their power, or may not have it.

  subscribe @0 (events :ConsoleEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  bringUp @1 (sent :Rpc.Sent) -> () $Meta.cxx("bring_up") $Meta.kind("void") $Meta.queue(16);
  # Brings the system up. It is refused, with an error that names each reason, unless the console
  # is down, every part of the system is there, no arm is in FAULT, and the emergency stop is
  # released.
  bringDown @2 (sent :Rpc.Sent) -> () $Meta.cxx("bring_down") $Meta.kind("void") $Meta.queue(16);
  # Disables everything in the opposite order, even while the system is being brought up, and
  # also what others have enabled. An arm in FAULT has no power, and stays in FAULT until somebody
  # enables or disables it.
  consoleState @3 (sent :Rpc.Sent) -> (value :ConsoleState, stamp :Int64)
      $Meta.cxx("console_state") $Meta.kind("read");
}

interface ConsoleEvents @0x84a81ff77b719ad6 $Meta.eventsOf("robots::Console") {
  # What a subscriber of Console receives.

  state @0 (row :ConsoleStateRow) -> ();
  # A new row of the columns asked for.
  status @1 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something has been done, and nothing is wrong.
  warning @2 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something was refused, or is not as it should be; the component goes on.
  error @3 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something failed, and needs somebody's attention.
  consoleState @4 (value :ConsoleState, stamp :Int64) -> () $Meta.cxx("console_state")
      $Meta.latched $Meta.queue(16);
  # Reports each change, and the last one to a client that connects.
  systemUse @5 (value :SystemUse, stamp :Int64) -> () $Meta.cxx("system_use") $Meta.latched
      $Meta.queue(16);
  # Reports each change, and the present one to a client that connects.
}

struct ConsoleStateRow @0xc2af8ce57e1b558c $Meta.stateOf("robots::Console") {
  # One row of the state table: what the read commands of Console answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  consoleState @3 :ConsoleState $Meta.cxx("console_state");
}

enum SystemUse @0xc3ffdfe7b8f7c55c $Meta.cxx("robots::SystemUse") $Meta.underlying("UInt8") {
  # Says if the arms of a system have had power since their processes began. Then somebody may have
  # pressed the emergency stop before its coordinator began, which does not know of it.

  unknown @0 $Meta.cxx("Unknown") $Meta.value(0);
  # some arm has not said it
  unused @1 $Meta.cxx("Unused") $Meta.value(1);
  # none has been permitted power
  used @2 $Meta.cxx("Used") $Meta.value(2);
}
