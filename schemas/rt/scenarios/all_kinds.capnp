@0xdd28bf47af28acce;
# The wire contract of rt/scenarios/all_kinds.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Pose = import "/robot_types/pose.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("scenarios::wire");
$Meta.header("rt/scenarios/all_kinds.h");

interface AllKinds @0xf6dce3f368753cbc $Meta.cxx("scenarios::AllKinds") {
  subscribe @0 (events :AllKindsEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  clear @1 (sent :Rpc.Sent) -> () $Meta.kind("void") $Meta.queue(16);
  # Forgets all values. This is a void command.
  setScalar @2 (value :Float64, sent :Rpc.Sent) -> () $Meta.cxx("set_scalar") $Meta.kind("write")
      $Meta.queue(16);
  # Keeps a value and tells it. This is a write.
  setVector @3 (value :Types.Vec3, sent :Rpc.Sent) -> () $Meta.cxx("set_vector")
      $Meta.kind("write") $Meta.queue(16);
  setRecord @4 (value :Pose.PosePrm, sent :Rpc.Sent) -> () $Meta.cxx("set_record")
      $Meta.kind("write") $Meta.queue(16);
  setText @5 (value :Text $Meta.capacity([31]), sent :Rpc.Sent) -> () $Meta.cxx("set_text")
      $Meta.kind("write") $Meta.queue(16);
  scalar @6 (sent :Rpc.Sent) -> (value :Float64, stamp :Int64) $Meta.kind("read");
  # Returns the value that is kept. This is a read.
  vector @7 (sent :Rpc.Sent) -> (value :Types.Vec3, stamp :Int64) $Meta.kind("read");
  record @8 (sent :Rpc.Sent) -> (value :Pose.PosePrm, stamp :Int64) $Meta.kind("read");
  text @9 (sent :Rpc.Sent) -> (value :Text $Meta.capacity([31]), stamp :Int64) $Meta.kind("read");
  twiceScalar @10 (value :Float64, sent :Rpc.Sent) -> (value :Float64) $Meta.cxx("twice_scalar")
      $Meta.kind("qualifiedRead");
  # Returns twice the value that is given. This is a qualified read.
  twiceVector @11 (value :Types.Vec3, sent :Rpc.Sent) -> (value :Types.Vec3)
      $Meta.cxx("twice_vector") $Meta.kind("qualifiedRead");
  twiceRecord @12 (value :Pose.PosePrm, sent :Rpc.Sent) -> (value :Pose.PosePrm)
      $Meta.cxx("twice_record") $Meta.kind("qualifiedRead");
  twiceText @13 (value :Text $Meta.capacity([15]), sent :Rpc.Sent) -> (value :Text $Meta.capacity([31]))
      $Meta.cxx("twice_text") $Meta.kind("qualifiedRead");
  takeScalar @14 (sent :Rpc.Sent) -> (value :Float64) $Meta.cxx("take_scalar")
      $Meta.kind("voidReturn") $Meta.queue(16);
  # Returns the value that was kept, and forgets it. This is a void command with a return.
  takeVector @15 (sent :Rpc.Sent) -> (value :Types.Vec3) $Meta.cxx("take_vector")
      $Meta.kind("voidReturn") $Meta.queue(16);
  takeRecord @16 (sent :Rpc.Sent) -> (value :Pose.PosePrm) $Meta.cxx("take_record")
      $Meta.kind("voidReturn") $Meta.queue(16);
  takeText @17 (sent :Rpc.Sent) -> (value :Text $Meta.capacity([31])) $Meta.cxx("take_text")
      $Meta.kind("voidReturn") $Meta.queue(16);
  swapScalar @18 (value :Float64, sent :Rpc.Sent) -> (value :Float64) $Meta.cxx("swap_scalar")
      $Meta.kind("writeReturn") $Meta.queue(16);
  # Keeps a value and returns the one before. This is a write with a return.
  swapVector @19 (value :Types.Vec3, sent :Rpc.Sent) -> (value :Types.Vec3)
      $Meta.cxx("swap_vector") $Meta.kind("writeReturn") $Meta.queue(16);
  swapRecord @20 (value :Pose.PosePrm, sent :Rpc.Sent) -> (value :Pose.PosePrm)
      $Meta.cxx("swap_record") $Meta.kind("writeReturn") $Meta.queue(16);
  swapText @21 (value :Text $Meta.capacity([31]), sent :Rpc.Sent) -> (value :Text $Meta.capacity([31]))
      $Meta.cxx("swap_text") $Meta.kind("writeReturn") $Meta.queue(16);
}

interface AllKindsEvents @0xdccb6d872bbaa8db $Meta.eventsOf("scenarios::AllKinds") {
  # What a subscriber of AllKinds receives.

  state @0 (row :AllKindsStateRow) -> ();
  # A new row of the columns asked for.
  cleared @1 (stamp :Int64) -> () $Meta.queue(16);
  # Tells that all values are forgotten. This is a void event.
  scalarSet @2 (value :Float64, stamp :Int64) -> () $Meta.cxx("scalar_set") $Meta.queue(16);
  # Tells the value that has been set. This is a write event.
  vectorSet @3 (value :Types.Vec3, stamp :Int64) -> () $Meta.cxx("vector_set") $Meta.queue(16);
  recordSet @4 (value :Pose.PosePrm, stamp :Int64) -> () $Meta.cxx("record_set") $Meta.queue(16);
  textSet @5 (value :Text $Meta.capacity([31]), stamp :Int64) -> () $Meta.cxx("text_set")
      $Meta.queue(16);
}

struct AllKindsStateRow @0xf9cad0ab043d03c9 $Meta.stateOf("scenarios::AllKinds") {
  # One row of the state table: what the read commands of AllKinds answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  scalar @3 :Float64;
  vector @4 :Types.Vec3;
  record @5 :Pose.PosePrm;
  text @6 :Text $Meta.capacity([31]);
}
