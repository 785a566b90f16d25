@0xf6a77f8f0da91b55;
# The wire contract of person/keyboard.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("person/keyboard.h");

struct KeyboardParameters @0x8e0f5ddd24393fee $Meta.cxx("robots::KeyboardParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  terminal @1 :Text $Meta.capacity([255]);
  speed @2 :Float64 = 0.02 $Meta.range(lowest = 0.001, highest = 0.25) $Meta.unit("m/s");
  turningSpeed @3 :Float64 = 0.3 $Meta.cxx("turning_speed") $Meta.range(lowest = 0.01, highest = 2)
      $Meta.unit("rad/s");
  opening @4 :Float64 = 0.5 $Meta.range(lowest = 0, highest = 1.047) $Meta.unit("rad");
  # The gripper is this far open when it is not closed.
  hold @5 :Int64 = 150000000 $Meta.period("1/1000000000");
  # The motion ends this long after the last repeat of its key. If the terminal's first repeat
  # comes later than this, the hand rests for a moment after the first press. It is 2 s at most.
}
