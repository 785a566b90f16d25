@0xa2b4c8d1e6f70912;
# What the two ends of a connection by calls say to each other when it is made. Its session has a socket for calls.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

using Peer = import "/suture/peer.capnp";

struct CallsRequest {
  socket @0 :UInt32;  # the number of the session's socket that is to carry them
}

struct CallsAnswer {
  connection @0 :UInt32;  # which of those on the socket this is
}

interface Calls {
  # The bootstrap interface of a socket for calls.

  contract @0 (connection :UInt32, counts :CommandCounts) -> (contract :Capability);
  # The capability of the contract's own interface (its generated schema). counts: wants to be told what becomes of its commands.
}

interface CommandCounts {
  tell @0 (tally :Peer.Tally) -> ();
  # What the provider's end has counted so far.
}
