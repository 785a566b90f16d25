@0xf90164c51984a728;
# The wire contract of evolution/choice.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("evolution::wire");
$Meta.header("evolution/choice.h");

enum Pace @0xd965413f87ed4f29 $Meta.cxx("evolution::Pace") $Meta.underlying("Int32") {
  slow @0 $Meta.cxx("Slow") $Meta.value(0);
  fast @1 $Meta.cxx("Fast") $Meta.value(1);
}

struct EvolutionChoiceEitherOfFloat64OrBool @0xf2e0150c08bcd166 {
  union {
    float64 @0 :Float64;
    bool @1 :Bool;
  }
}

struct EvolutionChoiceOptionalEitherOfFloat64OrBool @0x8f735f9e59a7668f {
  union {
    none @0 :Void;
    some @1 :EvolutionChoiceEitherOfFloat64OrBool;
  }
}

struct Inner @0x850a46b317c9d06a $Meta.cxx("evolution::Inner") {
  x @0 :Float64;
}

struct Choice @0xd9c96d4d1034fcf6 $Meta.cxx("evolution::Choice") {
  value @0 :EvolutionChoiceEitherOfFloat64OrBool;
  second @1 :EvolutionChoiceOptionalEitherOfFloat64OrBool;
  inner @2 :Inner;
  pace @3 :Pace;
}
