@0xeb8de4fb98205034;
# The wire contract of unit/shm/logbook.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("logs::wire");
$Meta.header("unit/shm/logbook.h");

interface Counter @0x8d109f3c32c4390e $Meta.cxx("logs::Counter") {
  subscribe @0 (events :CounterEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  count @1 (entries :Int32, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(16);
  entries @2 (sent :Rpc.Sent) -> (value :Int32, stamp :Int64) $Meta.kind("read");
}

interface CounterEvents @0xd85e1e5b50573220 $Meta.eventsOf("logs::Counter") {
  # What a subscriber of Counter receives.

  state @0 (row :CounterStateRow) -> ();
  # A new row of the columns asked for.
}

struct CounterStateRow @0xa143e04b1800f012 $Meta.stateOf("logs::Counter") {
  # One row of the state table: what the read commands of Counter answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  entries @3 :Int32;
}

interface Logbook @0xad2e8c9564bbd4b7 extends(Counter) $Meta.cxx("logs::Logbook") {
  # May be provided by a device only, because its text has no bound.

  subscribe @0 (events :LogbookEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  text @1 (sent :Rpc.Sent) -> (value :Text, stamp :Int64) $Meta.kind("read");
}

interface LogbookEvents @0x9862db22da862506 $Meta.eventsOf("logs::Logbook") {
  # What a subscriber of Logbook receives.

  state @0 (row :LogbookStateRow) -> ();
  # A new row of the columns asked for.
}

struct LogbookStateRow @0x965fbc2e54d0d858 $Meta.stateOf("logs::Logbook") {
  # One row of the state table: what the read commands of Logbook answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  entries @3 :Int32;
  text @4 :Text;
}
