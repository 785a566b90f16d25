@0x8b8eab397d99bfb7;
# The wire contract of robot_types/inputs.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("robot_types/inputs.h");

enum ButtonAction @0xd67d13156a146d91 $Meta.cxx("robots::ButtonAction") $Meta.underlying("UInt8") {
  undefined @0 $Meta.cxx("Undefined") $Meta.value(0);
  pressed @1 $Meta.cxx("Pressed") $Meta.value(1);
  released @2 $Meta.cxx("Released") $Meta.value(2);
  clicked @3 $Meta.cxx("Clicked") $Meta.value(3);
  doubleClicked @4 $Meta.cxx("DoubleClicked") $Meta.value(4);
}

struct ButtonEvent @0xad2a4c465d551e77 $Meta.cxx("robots::ButtonEvent") {
  # Corresponds to cisst's prmEventButton.

  type @0 :ButtonAction;
  stamp @1 :Int64 $Meta.clock("steady");
  valid @2 :Bool;
}

struct InputData @0x9f9e25cc2e3ab297 $Meta.cxx("robots::InputData") {
  # Corresponds to cisst's prmInputData.

  analogInputs @0 :List(Float64) $Meta.capacity([32]) $Meta.cxx("analog_inputs");
  digitalInputs @1 :List(Bool) $Meta.capacity([64]) $Meta.cxx("digital_inputs");
  stamp @2 :Int64 $Meta.clock("steady");
  valid @3 :Bool;
}

struct ImuSample @0xa3de4c37695d33c2 $Meta.cxx("robots::ImuSample") {
  # Corresponds to cisst's prmIMUSensors.

  orientation @0 :Types.Quat;
  angularVelocity @1 :Types.Vec3 $Meta.cxx("angular_velocity") $Meta.unit("rad/s");
  linearAcceleration @2 :Types.Vec3 $Meta.cxx("linear_acceleration") $Meta.unit("m/s2");
  stamp @3 :Int64 $Meta.clock("steady");
  valid @4 :Bool;
}
