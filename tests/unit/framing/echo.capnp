@0x99306e8d4ba5433f;
# What the tests of links talk.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::framing::test");

interface Echo {
  echo @0 (data :Data) -> (data :Data);
  fail @1 (text :Text) -> ();
  never @2 () -> ();
}
