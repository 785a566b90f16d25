@0xf65fd01f3c5f31cf;
# What the two ends of a connection by frames say to each other when it is made. Its session has a socket for frames.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

struct FrameRequest {
  layout @0 :Text;    # of the contract's slots; equal layouts may send them as they are. Empty: slots are not understood
  socket @1 :UInt32;  # the number of the session's socket that is to carry them, and the epoch of each frame on it

  commands @2 :List(Method);
  # By the number that the client gives a command in its frames.

  struct Method {
    interface @0 :UInt64;  # the id of the interface of the contract that declares it
    ordinal @1 :UInt16;
  }

  latest @3 :List(Bool);
  # By the same number: if only the newest of the client's counts, so that one without an answer uses no credit. A build of before
  # does not say so; for what is missing here, the provider's contract counts.
}

struct FrameAnswer {
  connection @0 :UInt32;  # which of those on the socket this is
  encoded @1 :Bool;       # values are Cap'n Proto messages; else slots
}
