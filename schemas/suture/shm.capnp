@0xcd6f3fe96fa50c6b;
# What the two ends of a connection by shared memory say to each other when it is made.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

struct SharedRequest {
  layout @0 :Text;         # of the contract's slots and queues; equal layouts may share memory
  bell @1 :SharedMemory;   # wakes the caller's thread
}

struct SharedChannel {
  channel @0 :SharedMemory;   # the queues; both sides write
  state @1 :SharedMemory;     # the provider's state table; sealed against other writers
  bell @2 :SharedMemory;      # wakes the provider's thread
  columns @3 :List(UInt32);   # sizes of the table's columns
  rows @4 :UInt32;
}

interface SharedMemory {
  # A sealed memfd: the capability's file descriptor. It has no methods.
}
