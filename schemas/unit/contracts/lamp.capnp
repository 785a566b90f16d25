@0x8c7d29ad144f028b;
# The wire contract of unit/contracts/lamp.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Messages = import "/suture/standard/messages.capnp";
$Cxx.namespace("contracts::wire");
$Meta.header("unit/contracts/lamp.h");

interface Lamp @0xd4cb2344bc7abacc extends(Messages.Messages) $Meta.cxx("contracts::Lamp") {
  subscribe @0 (events :LampEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  light @1 (on :Bool, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  lit @2 (sent :Rpc.Sent) -> (value :Bool, stamp :Int64) $Meta.kind("read");
}

interface LampEvents @0xd29be22d5548c1be $Meta.eventsOf("contracts::Lamp") {
  # What a subscriber of Lamp receives.

  state @0 (row :LampStateRow) -> ();
  # A new row of the columns asked for.
  status @1 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something has been done, and nothing is wrong.
  warning @2 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something was refused, or is not as it should be; the component goes on.
  error @3 (value :Messages.Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something failed, and needs somebody's attention.
}

struct LampStateRow @0xc60e3f090bda1270 $Meta.stateOf("contracts::Lamp") {
  # One row of the state table: what the read commands of Lamp answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  lit @3 :Bool;
}
