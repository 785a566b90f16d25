@0xf14245b82da72b32;
# The wire contract of reference/arm_types.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("reference::wire");
$Meta.header("reference/arm_types.h");

enum Mode @0x89daa6df134ae03e $Meta.cxx("reference::Mode") $Meta.underlying("UInt8") {
  disabled @0 $Meta.cxx("Disabled") $Meta.value(0);
  enabled @1 $Meta.cxx("Enabled") $Meta.value(1);
}

struct PoseStamped @0x9e5a942c3e52a9b7 $Meta.cxx("reference::PoseStamped") {
  # A pose with its time.

  pose @0 :Types.Pose $Meta.unit("m");
  # tip in base
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}

struct JointState @0xe82fac248b31c66b $Meta.cxx("reference::JointState") {
  name @0 :List(Text) $Meta.capacity([8, 15]);
  position @1 :List(Float64) $Meta.capacity([8]) $Meta.unit("rad");
}
