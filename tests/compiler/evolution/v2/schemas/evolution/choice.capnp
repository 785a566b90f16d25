@0xf90164c51984a728;
# The wire contract of evolution/choice.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("evolution::wire");
$Meta.header("evolution/choice.h");

enum Pace @0xd965413f87ed4f29 $Meta.cxx("evolution::Pace") $Meta.underlying("Int32") {
  slow @0 $Meta.cxx("Slow") $Meta.value(1);
  quick @1 $Meta.cxx("Quick") $Meta.value(0);
}

struct EvolutionChoiceEitherOfInt32OrFloat64OrBool @0xf2e0150c08bcd166 {
  union {
    float64 @0 :Float64;
    bool @1 :Bool;
    int32 @2 :Int32;
  }
}

struct EvolutionChoiceOptionalEitherOfInt32OrFloat64OrBool @0x8f735f9e59a7668f {
  union {
    none @0 :Void;
    some @1 :EvolutionChoiceEitherOfInt32OrFloat64OrBool;
  }
}

struct Part @0x850a46b317c9d06a $Meta.cxx("evolution::Part") {
  x @0 :Float64;
}

struct Choice @0xd9c96d4d1034fcf6 $Meta.cxx("evolution::Choice") {
  value @0 :EvolutionChoiceEitherOfInt32OrFloat64OrBool;
  second @1 :EvolutionChoiceOptionalEitherOfInt32OrFloat64OrBool;
  inner @2 :Part;
  pace @3 :Pace;
}
