@0xd1c0ffee0badf00d;
# Each number is a field: faster than lists of them.
using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("peers::calls");
struct Pose {
  r0 @0 :Float64; r1 @1 :Float64; r2 @2 :Float64; r3 @3 :Float64; r4 @4 :Float64;
  r5 @5 :Float64; r6 @6 :Float64; r7 @7 :Float64; r8 @8 :Float64;
  x @9 :Float64; y @10 :Float64; z @11 :Float64;
  timestamp @12 :Float64;
  valid @13 :Bool;
  frame @14 :Text;
  reference @15 :Text;
}
struct Blob {
  timestamp @0 :Float64;
  data @1 :List(Float64);
}
interface Echo {
  echo @0 (sent :Pose) -> (back :Pose);
  echoBlob @1 (sent :Blob) -> (back :Blob);
  push @2 (sent :Pose) -> stream;
  sync @3 () -> ();
}
