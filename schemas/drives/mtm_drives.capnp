@0xbee89178facac135;
# The wire contract of drives/mtm_drives.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using DriveDynamics = import "/drives/drive_dynamics.capnp";
using Side = import "/robot_types/side.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("drives/mtm_drives.h");

enum MasterSide @0x93df6efffc351cf4 $Meta.cxx("robots::MasterSide") $Meta.removed("MasterSide")
    $Meta.underlying("UInt8") {
  left @0 $Meta.cxx("Left") $Meta.value(0);
  right @1 $Meta.cxx("Right") $Meta.value(1);
}

struct MtmDrivesParameters @0xe72c8047229da521 $Meta.cxx("robots::MtmDrivesParameters") {
  side @0 :Side.Side;
  # Says which of a surgeon's two masters it is, because their joints have mirrored limits.
  period @1 :Int64 = 667000 $Meta.period("1/1000000000");
  timeConstant @2 :Float64 = 0.01 $Meta.cxx("time_constant")
      $Meta.range(lowest = 1e-04, highest = 10) $Meta.unit("s");
  # The measured joints trail their goal by this time: here, the hand that moves the master.
  angularRate @3 :Float64 = 4.0 $Meta.cxx("angular_rate") $Meta.range(lowest = 0.01, highest = 20)
      $Meta.unit("rad/s");
  # The joints can be this fast.
  permit @4 :Int64 = 30000000 $Meta.period("1/1000000000");
  # The permit of the emergency stop may be this old: from 1 ms to 1 s. With 0, power needs none,
  # as on a bench where nobody can be hurt; a stop that is connected still takes it.
  dynamics @5 :DriveDynamics.DriveDynamics;
  # Lag: the joints trail their goal. RigidBody: motors move bodies that have mass, and
  # `time_constant` does not count.
  rigidBody @6 :DriveDynamics.RigidBodyOptions $Meta.cxx("rigid_body");
  # These have an effect only with RigidBody.
}
