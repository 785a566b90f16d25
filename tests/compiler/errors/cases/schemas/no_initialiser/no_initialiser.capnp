@0xd2a4870775121994;
# The wire contract of no_initialiser.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Bare = import "/demo/bare.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("demo::wire");
$Meta.header("no_initialiser.h");

enum Mode @0x90ede0e67b099ab2 $Meta.cxx("demo::Mode") $Meta.underlying("Int32") {
  servo @0 $Meta.cxx("Servo") $Meta.value(1);
  off @1 $Meta.cxx("Off") $Meta.value(0);
}

enum Step @0xf2c53edaaf5d4357 $Meta.cxx("demo::Step") $Meta.underlying("Int32") {
  first @0 $Meta.cxx("First") $Meta.value(1);
  second @1 $Meta.cxx("Second") $Meta.value(2);
}

struct NoInitialiserOptionalFloat64 @0xf4b42ce51a19e6a5 {
  union {
    none @0 :Void;
    some @1 :Float64;
  }
}

struct Point @0xb88e5bb1d01bd979 $Meta.cxx("lib::Point") {
  x @0 :Float64;
  y @1 :Float64;
}

struct Grip @0xbd460b598ece1639 $Meta.cxx("demo::Grip") {
  width @0 :Float64;
  closed @1 :Bool;
  code @2 :UInt8;
  other @3 :UInt8;
  raw @4 :UInt8;
  mode @5 :Mode = off;
  step @6 :Step;
  force @7 :List(Float64) $Meta.shape("2");
  counts @8 :List(List(Int32)) $Meta.shape("3,2");
  pause @9 :Int64 $Meta.period("1/1000");
  axis @10 :Types.Vec3;
  turn @11 :Types.Quat;
  pose @12 :Types.Pose;
  braces @13 :Types.Vec3;
  corners @14 :List(Types.Vec2) $Meta.shape("2");
  share @15 :Float32 $Meta.range(lowest = -1, highest = 1);
  aligned @16 :Float64;
}

struct InMacro @0xa141ae559317bf9b $Meta.cxx("demo::InMacro") {
  plain @0 :Float64;
}

struct InList @0x855a9951b97e2993 $Meta.cxx("demo::InList") {
  listed @0 :Float64 = 1.0;
  zero @1 :Float64;
  forgotten @2 :Float64;
  axis @3 :Types.Vec3;
}

struct Defaulted @0xdb70dcefa4bf6cb2 $Meta.cxx("demo::Defaulted") {
  number @0 :Float64;
}

struct IntBox @0x99f40a84514762ec $Meta.cxx("demo::IntBox") {
  value @0 :Int32;
  mode @1 :Mode = off;
}

struct RealBox @0x84e5d443eb94e2e8 $Meta.cxx("demo::RealBox") {
  value @0 :Float64;
  mode @1 :Mode = off;
}

struct ModeBox @0xb3886abf1068894a $Meta.cxx("demo::ModeBox") {
  value @0 :Mode = off;
  mode @1 :Mode = off;
}

struct BareInt @0xf09897ba12c196f6 $Meta.cxx("demo::BareInt") {
  value @0 :Int32;
}

struct Quiet @0xc504d0fbfbe84ce9 $Meta.cxx("demo::Quiet") {
  number @0 :Float64 = 1.0;
  zero @1 :Float64;
  mode @2 :Mode = off;
  force @3 :List(Float64) $Meta.shape("2");
  both @4 :List(Float64) $Meta.shape("2");
  pause @5 :Int64 $Meta.period("1/1");
  stamp @6 :Int64 $Meta.clock("steady");
  axis @7 :Types.Vec3;
  perhaps @8 :NoInitialiserOptionalFloat64;
  text @9 :Text $Meta.capacity([3]);
  list @10 :List(Float64) $Meta.capacity([3]);
  point @11 :Point;
  bare @12 :Bare.Bare;
  box @13 :BareInt;
  settled @14 :Settled;
  given @15 :Given;
  none @16 :NoInitialiserOptionalPoint;
}

struct NoInitialiserOptionalPoint @0xa33d63b2bca19440 {
  union {
    none @0 :Void;
    some @1 :Point;
  }
}

struct Wrench @0xb185733c1270d410 $Meta.cxx("lib::Wrench") {
  base @0 :Point;
  moment @1 :Point;
  label @2 :Text $Meta.capacity([3]);
}

struct Settled @0xa579240797fe7e95 $Meta.cxx("lib::Settled") {
  x @0 :Float64;
}

struct Given @0x970f71fec7b97669 $Meta.cxx("lib::Given") {
  x @0 :Float64;
  axis @1 :Types.Vec3;
}

struct OfOthers @0xfe85210dfda022c1 $Meta.cxx("demo::OfOthers") {
  point @0 :Point;
  wrench @1 :Wrench;
  both @2 :List(Point) $Meta.shape("2");
}
