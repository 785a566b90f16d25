@0xd8c0fa594a41f0cf;
# The wire contract of person/gamepad.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using AxisRange = import "/person/axis_range.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("person/gamepad.h");

struct GamepadParameters @0xf575f5598b106427 $Meta.cxx("robots::GamepadParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  file @1 :Text $Meta.capacity([255]);
  # The file is an input device, or a FIFO of its events. A name below /dev/input/by-id stays the
  # same when others are plugged in.
  stick @2 :AxisRange.AxisRange;
  trigger @3 :AxisRange.AxisRange;
  deadZone @4 :Float64 = 0.15 $Meta.cxx("dead_zone") $Meta.range(lowest = 0.01, highest = 0.9);
  # A stick is at rest within this share of the way from its middle to its end.
  speed @5 :Float64 = 0.05 $Meta.range(lowest = 0.001, highest = 0.25) $Meta.unit("m/s");
  # The hand is as fast as this while a stick is at its end.
  turningSpeed @6 :Float64 = 0.5 $Meta.cxx("turning_speed") $Meta.range(lowest = 0.01, highest = 2)
      $Meta.unit("rad/s");
  opening @7 :Float64 = 0.5 $Meta.range(lowest = 0, highest = 1.047) $Meta.unit("rad");
  # The gripper is open this far while the trigger is released.
  retry @8 :Int64 = 1000000000 $Meta.period("1/1000000000");
  # A device that is not there is looked for once in this time.
}
