@0x9aee15378ce6564c;
# The wire contract of suture/standard/lifecycle.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("suture::wire");
$Meta.header("suture/standard/lifecycle.h");

enum ComponentState @0x8e5bed957aeeb624 $Meta.cxx("suture::ComponentState")
    $Meta.underlying("UInt8") {
  constructed @0 $Meta.cxx("Constructed") $Meta.value(0);
  configured @1 $Meta.cxx("Configured") $Meta.value(1);
  running @2 $Meta.cxx("Running") $Meta.value(2);
  suspended @3 $Meta.cxx("Suspended") $Meta.value(3);
  # keeps its thread and its connections, and only waits for resume
  faulted @4 $Meta.cxx("Faulted") $Meta.value(4);
  # a handler or hook threw; the end of this component, not of its process
  stopped @5 $Meta.cxx("Stopped") $Meta.value(5);
}

struct StateChange @0x94110f1e97b939a5 $Meta.cxx("suture::StateChange") {
  # Says that a component has come into a state.

  state @0 :ComponentState;
  fault @1 :Text $Meta.capacity([255]);
  # The component threw this, if the state is Faulted; the end of the text may be cut off.
  stamp @2 :Int64 $Meta.clock("steady");
}

interface Lifecycle @0xc0c56c9588a77b40 $Meta.cxx("suture::Lifecycle") {
  # Lifecycle is the provided interface "component" of every component that a manager has. It is
  # served even while the component is suspended or faulted.

  subscribe @0 (events :LifecycleEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  suspend @1 (sent :Rpc.Sent) -> (value :Bool) $Meta.kind("voidReturn") $Meta.queue(16);
  # Suspends the component, which does nothing from its next cycle on. Returns false if it is not
  # running.
  resume @2 (sent :Rpc.Sent) -> (value :Bool) $Meta.kind("voidReturn") $Meta.queue(16);
  # Lets the component go on. Returns false if it is not suspended.
  componentState @3 (sent :Rpc.Sent) -> (value :ComponentState, stamp :Int64)
      $Meta.cxx("component_state") $Meta.kind("read");
  resumeConnection @4 (required :Text $Meta.capacity([63]), sent :Rpc.Sent) -> (value :ResumeOutcome)
      $Meta.cxx("resume_connection") $Meta.kind("writeReturn") $Meta.queue(16);
  # Lets the commands of a required interface through again, which await their operator after a
  # loss or a value that was too old.
}

interface LifecycleEvents @0xa4c750cb89591cca $Meta.eventsOf("suture::Lifecycle") {
  # What a subscriber of Lifecycle receives.

  state @0 (row :LifecycleStateRow) -> ();
  # A new row of the columns asked for.
  stateChanged @1 (value :StateChange, stamp :Int64) -> () $Meta.cxx("state_changed") $Meta.latched
      $Meta.queue(16);
  # Reports each transition once, and the last one to a client that subscribes later.
}

struct LifecycleStateRow @0xf777f0543682aa19 $Meta.stateOf("suture::Lifecycle") {
  # One row of the state table: what the read commands of Lifecycle answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  componentState @3 :ComponentState $Meta.cxx("component_state");
}

enum ResumeOutcome @0xc2c9babc8f01c05f $Meta.cxx("suture::ResumeOutcome") $Meta.underlying("UInt8") {
  # Says what became of a request to let the commands of a connection through again.

  resumed @0 $Meta.cxx("Resumed") $Meta.value(0);
  asked @1 $Meta.cxx("Asked") $Meta.value(1);
  # of a device: it happens when it uses the connection next, unless that is lost then
  noSuchInterface @2 $Meta.cxx("NoSuchInterface") $Meta.value(2);
  # the component requires none of that name
  notConnected @3 $Meta.cxx("NotConnected") $Meta.value(3);
  notAwaiting @4 $Meta.cxx("NotAwaiting") $Meta.value(4);
  # it awaits no operator, so nothing has to be done
  providerLost @5 $Meta.cxx("ProviderLost") $Meta.value(5);
  # or it is suspended or faulted: a connection to it cannot be resumed
}
