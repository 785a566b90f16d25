@0x954c0ff33f975267;
# The wire contract of drives/drive_dynamics.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("drives/drive_dynamics.h");

enum DriveDynamics @0xf9d9ac4e5a5868fe $Meta.cxx("robots::DriveDynamics") $Meta.underlying("UInt8") {
  lag @0 $Meta.cxx("Lag") $Meta.value(0);
  # joints without mass trail their goals by a time constant
  rigidBody @1 $Meta.cxx("RigidBody") $Meta.value(1);
  # motors move bodies that have mass, against gravity, friction and stops
}

struct RigidBodyOptions @0xebb0c1af002736b6 $Meta.cxx("robots::RigidBodyOptions") {
  # Chooses the properties of joints with mass.

  gravityCompensation @0 :Bool = true $Meta.cxx("gravity_compensation");
  # If it is true, the motors carry the arm's weight beside what their controllers give, unless a
  # goal asks them not to. If it is false, they never do.
  quantisation @1 :Bool = true;
  # If it is true, encoders read whole counts.
  noise @2 :Float64 $Meta.range(lowest = 0, highest = 1000);
  # The noise of encoders has this standard deviation, in counts.
  seed @3 :UInt32 = 1;
  # Equal seeds, goals and times give equal noise.
  brakes @4 :Bool = true;
  # If it is true, brakes hold the joints without power. The PSM and the MTM of the da Vinci
  # Classic have none, so what their motors carried sinks then.
  currentGain @5 :Float64 = 1.0 $Meta.cxx("current_gain") $Meta.range(lowest = 0.1, highest = 100);
  # Sensors measure this share of each motor's current. Motors never give more than they can, so a
  # test must cause an over-current: a sensor that measures too much is one to the arm.
}
