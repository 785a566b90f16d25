@0xc19c1a77bace573b;
# The wire contract of 03_own_data_type/tracker.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Observation = import "/03_own_data_type/observation.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("tracking::wire");
$Meta.header("03_own_data_type/tracker.h");

interface Tracker @0xfadff631147631f3 $Meta.cxx("tracking::Tracker") {
  subscribe @0 (events :TrackerEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  observation @1 (sent :Rpc.Sent) -> (value :Observation.Observation, stamp :Int64)
      $Meta.kind("read");
  # Returns the newest observation; never waits for anyone.
}

interface TrackerEvents @0xbe3f6f6614035211 $Meta.eventsOf("tracking::Tracker") {
  # What a subscriber of Tracker receives.

  state @0 (row :TrackerStateRow) -> ();
  # A new row of the columns asked for.
}

struct TrackerStateRow @0xfa119c601108b062 $Meta.stateOf("tracking::Tracker") {
  # One row of the state table: what the read commands of Tracker answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  observation @3 :Observation.Observation;
}
