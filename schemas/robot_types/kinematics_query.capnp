@0xcc586983bc637af2;
# The wire contract of robot_types/kinematics_query.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/kinematics_query.h");

struct ForwardKinematicsRequest @0xc7e4b331b1256ab8 $Meta.cxx("robots::ForwardKinematicsRequest") {
  jp @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
}

struct ForwardKinematicsResponse @0xf4d4f62736e384ee $Meta.cxx("robots::ForwardKinematicsResponse") {
  cp @0 :Types.Pose $Meta.unit("m");
  result @1 :Bool;
  message @2 :Text $Meta.capacity([63]);
  # Says why there is no answer; empty when `result`.
}

struct InverseKinematicsRequest @0xe4e42c0ed163244d $Meta.cxx("robots::InverseKinematicsRequest") {
  cp @0 :Types.Pose $Meta.unit("m");
  jp @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  # The search begins here.
}

struct InverseKinematicsResponse @0x92a37797402bc4bd $Meta.cxx("robots::InverseKinematicsResponse") {
  jp @0 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
  result @1 :Bool;
  message @2 :Text $Meta.capacity([63]);
  # Says why there is no answer; empty when `result`.
}
