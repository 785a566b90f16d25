@0xeaffcb735e2d2616;
# The wire contract of arm/gripper.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using JointCommands = import "/robot_types/joint_commands.capnp";
using Joints = import "/robot_types/joints.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("arm/gripper.h");

interface Gripper @0x8486a1563ccf77e4 $Meta.cxx("robots::Gripper") {
  # The master provides this as an interface of its own, "Gripper". Reads are from the end of its
  # last cycle. Joint vectors have one entry, the angle between the handles in rad: 0 is closed, and
  # a smaller angle is squeezed harder. Nothing drives the gripper, so it is measured with or
  # without power of the master.

  subscribe @0 (events :GripperEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  configurationJs @1 (sent :Rpc.Sent) -> (value :JointCommands.JointConfiguration, stamp :Int64)
      $Meta.cxx("configuration_js") $Meta.kind("read");
  # Says what the joint is and what it may do.
  measuredJs @2 (sent :Rpc.Sent) -> (value :Joints.JointState, stamp :Int64)
      $Meta.cxx("measured_js") $Meta.kind("read");
  # Says where the joint is. The stamp is that of the drives' cycle that measured it. Before the
  # first such cycle the value is not valid.
}

interface GripperEvents @0xc5f5014ab20db54c $Meta.eventsOf("robots::Gripper") {
  # What a subscriber of Gripper receives.

  state @0 (row :GripperStateRow) -> ();
  # A new row of the columns asked for.
  closed @1 (value :Bool, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports if the gripper is closed, each time that this changes, and the last one to a client
  # that connects: dVRK's gripper/closed.
}

struct GripperStateRow @0xb54cebda06a7e912 $Meta.stateOf("robots::Gripper") {
  # One row of the state table: what the read commands of Gripper answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  configurationJs @3 :JointCommands.JointConfiguration $Meta.cxx("configuration_js");
  measuredJs @4 :Joints.JointState $Meta.cxx("measured_js");
}
