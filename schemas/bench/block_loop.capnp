@0xe4c771d49fac5940;
# The wire contract of bench/block_loop.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("bench::wire");
$Meta.header("bench/block_loop.h");

struct SmallBlock @0xbed5520df9ca5c0d $Meta.cxx("bench::SmallBlock") {
  # As large as a pose.

  bytes @0 :Data $Meta.capacity([120]);
}

struct LargeBlock @0xb5fa8205b68955f8 $Meta.cxx("bench::LargeBlock") {
  # As large as an image at most.

  bytes @0 :Data $Meta.capacity([1048576]);
}

interface SmallBlocks @0xa0a4d60db53264a8 $Meta.cxx("bench::SmallBlocks") {
  subscribe @0 (events :SmallBlocksEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  bounce @1 (block :SmallBlock, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
  # Client, server, client: sends the block back as the event echo.
}

interface SmallBlocksEvents @0xf92746b2d211fcbe $Meta.eventsOf("bench::SmallBlocks") {
  # What a subscriber of SmallBlocks receives.

  state @0 (row :SmallBlocksStateRow) -> ();
  # A new row of the columns asked for.
  echo @1 (value :SmallBlock, stamp :Int64) -> () $Meta.queue(2);
}

struct SmallBlocksStateRow @0xb2befd803231da25 $Meta.stateOf("bench::SmallBlocks") {
  # One row of the state table: what the read commands of SmallBlocks answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}

interface LargeBlocks @0xc823fae657e6cd4d $Meta.cxx("bench::LargeBlocks") {
  subscribe @0 (events :LargeBlocksEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  bounce @1 (block :LargeBlock, sent :Rpc.Sent) -> () $Meta.kind("write") $Meta.queue(2);
  # Client, server, client: sends the block back as the event echo.
}

interface LargeBlocksEvents @0xde18174f4b5898cb $Meta.eventsOf("bench::LargeBlocks") {
  # What a subscriber of LargeBlocks receives.

  state @0 (row :LargeBlocksStateRow) -> ();
  # A new row of the columns asked for.
  echo @1 (value :LargeBlock, stamp :Int64) -> () $Meta.queue(2);
}

struct LargeBlocksStateRow @0xc00ca2fc276d186f $Meta.stateOf("bench::LargeBlocks") {
  # One row of the state table: what the read commands of LargeBlocks answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
