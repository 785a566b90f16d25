@0xebccbe254fa9def8;
# The wire contract of drives/psm_drives.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using DriveDynamics = import "/drives/drive_dynamics.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("drives/psm_drives.h");

struct PsmDrivesParameters @0x85a1d19046bdb4e7 $Meta.cxx("robots::PsmDrivesParameters") {
  period @0 :Int64 = 667000 $Meta.period("1/1000000000");
  timeConstant @1 :Float64 = 0.01 $Meta.cxx("time_constant")
      $Meta.range(lowest = 1e-04, highest = 10) $Meta.unit("s");
  # The measured joints trail their goal by this time.
  angularRate @2 :Float64 = 4.0 $Meta.cxx("angular_rate") $Meta.range(lowest = 0.01, highest = 20)
      $Meta.unit("rad/s");
  # The rotating joints can be this fast.
  insertionRate @3 :Float64 = 0.4 $Meta.cxx("insertion_rate")
      $Meta.range(lowest = 0.001, highest = 2) $Meta.unit("m/s");
  # The insertion can be this fast.
  permit @4 :Int64 = 30000000 $Meta.period("1/1000000000");
  # The permit of the emergency stop may be this old: from 1 ms to 1 s. With 0, power needs none,
  # as on a bench where nobody can be hurt; a stop that is connected still takes it.
  dynamics @5 :DriveDynamics.DriveDynamics;
  # Lag: the joints trail their goal. RigidBody: motors move bodies that have mass, and
  # `time_constant` does not count.
  rigidBody @6 :DriveDynamics.RigidBodyOptions $Meta.cxx("rigid_body");
  # These have an effect only with RigidBody.
  jawRate @7 :Float64 = 12.566 $Meta.cxx("jaw_rate") $Meta.range(lowest = 0.01, highest = 50)
      $Meta.unit("rad/s");
  # The jaw can be this fast; by default as in the da Vinci Research Kit's teleoperation.
}
