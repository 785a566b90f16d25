@0xb68883995f29c577;
# What two processes say to each other directly.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

using Manager = import "/suture/manager.capnp";

interface Peer {
  # The bootstrap interface of a process.

  hello @0 (version :UInt16, process :Text, bootId :Text) -> HelloResults;
  # The two stamps are the responder's steady clock, in nanoseconds; with the caller's own stamps around
  # the call they give the clock offset and its error.
  struct HelloResults {
    process @0 :Text;
    bootId @1 :Text;  # equal: the same machine since the same start, so the clocks are one
    received @2 :Int64;
    sent @3 :Int64;
    union {
      accepted @4 :Void;
      refused @5 :Manager.Refusal;
    }
  }

  connect @1 ConnectRequest -> ConnectResults;

  describe @2 () -> (components :List(Manager.ComponentRecord));

  ping @3 () -> (received :Int64, sent :Int64);
  # Clock stamps as in hello, at any time; also the heartbeat of a silent link.

  open @4 (component :Text, interface :Text) -> OpenResults;
  # A provided interface as its plain typed capability, for programs that know only its schema.
  struct OpenResults {
    union {
      contract @0 :Capability;
      refused @1 :Manager.Refusal;
    }
  }
}

struct ConnectRequest {
  fromProcess @0 :Text;
  fromComponent @1 :Text;
  required @2 :Text;
  toComponent @3 :Text;
  provided @4 :Text;
  contract @5 :Text;      # its C++ name
  hash @6 :Text;          # of the wire contract; equal hashes are compatible
  description @7 :Text;   # the self-description (JSON), to say what differs when the hashes do
  events @8 :UInt64;      # bit i: wants event i of the contract
  clockOffset @9 :Int64;  # caller's clock minus responder's, ns, as the caller measured it
  notices @10 :Notices;   # how the caller learns what befalls the connection
}

struct ConnectResults {
  union {
    accepted :group {
      contract @0 :Capability;
      # The capability of the contract's own interface (its generated schema).
      connection @1 :Connection;
      offered @3 :UInt16 = 65535;
      # How many of the caller's commands, from the first, the provider has: it may lack optional ones.
      rows @4 :UInt32 = 64;
      # How many rows of state the provider keeps; so does the caller, of those that arrive.
    }
    refused @2 :Manager.Refusal;
  }
}

interface Notices {
  faulted @0 (reason :Text) -> ();
  # The provider's handler threw: its component is parked, the connection stands.
  closed @1 () -> ();
  # The provider has taken the connection down.
  suspended @2 () -> ();
  # The provider's component executes nothing until resumed() says so: its commands are refused.
  resumed @3 () -> ();
  replayed @4 (event :UInt16, stamp :Int64) -> ();
  # The next such event on this link is the last value of a latched one, for a new subscriber; it was emitted
  # at `stamp` of the provider's steady clock, ns.
}

interface Connection {
  # Lives as long as the connection: dropping it disconnects.
}
