@0xb5c32a5763d9bed4;
# The wire contract of robot_types/operating_state.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/operating_state.h");

enum ArmState @0xc9ed1800ca1df7eb $Meta.cxx("robots::ArmState") $Meta.underlying("UInt8") {
  # An ArmState is one of the states of CRTK.

  undefined @0 $Meta.cxx("Undefined") $Meta.value(0);
  disabled @1 $Meta.cxx("Disabled") $Meta.value(1);
  enabled @2 $Meta.cxx("Enabled") $Meta.value(2);
  paused @3 $Meta.cxx("Paused") $Meta.value(3);
  fault @4 $Meta.cxx("Fault") $Meta.value(4);
}

struct OperatingState @0x8109968bd491318f $Meta.cxx("robots::OperatingState") {
  # An OperatingState is CRTK's operating_state.

  state @0 :ArmState;
  subState @1 :Text $Meta.capacity([15]) $Meta.cxx("sub_state");
  # Says for people what the arm is doing within its state: "holding", "servo_cp".
  isHomed @2 :Bool $Meta.cxx("is_homed");
  isBusy @3 :Bool $Meta.cxx("is_busy");
  # This is true while a move is under way; servo commands do not set it.
  stamp @4 :Int64 $Meta.clock("steady");
  # One of the above changed last at this time.
}
