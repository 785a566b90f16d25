@0xb68883995f29c577;
# What two processes say to each other directly.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

using Manager = import "/suture/manager.capnp";
using Schema = import "/capnp/schema.capnp";

interface Peer {
  # The bootstrap interface of a process. One link to it, the control link, carries the session of its caller with it.

  hello @0 (version :UInt16, process :Text, bootId :Text, incarnation :UInt64) -> HelloResults;
  # incarnation: a number that this start of the process has chosen at random; 0: none.
  # The two stamps are the responder's steady clock, in nanoseconds; with the caller's own stamps around
  # the call they give the clock offset and its error.
  struct HelloResults {
    process @0 :Text;
    bootId @1 :Text;  # equal: the same machine since the same start, so the clocks are one
    received @2 :Int64;
    sent @3 :Int64;
    incarnation @6 :UInt64;
    union {
      accepted @4 :Void;
      refused @5 :Manager.Refusal;
    }
  }

  connect @1 ConnectRequest -> ConnectResults;

  describe @2 () -> (components :List(Manager.ComponentRecord), connections :List(ConnectionState));
  # connections: of the components' required interfaces that have been connected. Null: the responder was built before it told them.

  ping @3 (heard :Int64, components :List(Text)) -> (received :Int64, sent :Int64, tasks :List(TaskActivity));
  # Clock stamps as in hello, at any time; also the heartbeat of the session. heard: `sent` of the answer before, which
  # this answers; 0: none. components: those whose tasks every answer tells of, in this order, from this one on; null: as before.

  open @4 (component :Text, interface :Text) -> OpenResults;
  # A provided interface as its plain typed capability, for programs that know only its schema. Whoever drops the capability lets go of
  # the interface: its subscription ends then.
  struct OpenResults {
    union {
      contract @0 :Capability;
      refused @1 :Manager.Refusal;
    }
  }

  explain @5 (component :Text, interface :Text, side :Side) -> ExplainResults;
  # What an interface is, for programs that know nothing of it.
  enum Side {
    provided @0;
    required @1;
  }
  struct ExplainResults {
    union {
      explained @0 :Explanation;
      refused @1 :Manager.Refusal;
    }
  }

  socket @6 (lane :Text) -> (number :UInt32, token :Data);
  # A second connection to the address of this link, for that lane of this session; after hello. It is awaited once: it says the eight
  # letters SUTFRAME and the token, is told the same, and is the lane's from then on. number: what both call it.

  compared @7 (clockOffset :Int64, clockError :Int64);
  # How the caller has compared the two clocks: its own minus the responder's, and how wrong that may be now, either way; ns.
  # It holds for all connections of the session, and is not sent where both have one clock.
}

struct Explanation {
  description @0 :Text;  # the self-description (JSON): kinds, types, units, documentation
  contract @1 :UInt64;   # id of the contract's own interface; its events interface is what subscribe() takes
  nodes @2 :List(Schema.Node);
  # That interface and everything it is made of, complete. Named without the files they were written in.
  bases @3 :List(Text);  # descriptions of the contracts it derives from, the nearest first
}

struct ConnectionState {
  # How a required interface of the responder is connected, for people.
  component @0 :Text;
  required @1 :Text;
  provided @2 :Text;  # "psm-host:PSM/Arm"
  lane @3 :Text;
  status @4 :Text;    # "connected"
  since @5 :Int64;    # of that status: the responder's steady clock, ns
  awaitsOperator @6 :Bool;
}

struct TaskActivity {
  # How the thread that serves a component does: one that is running, or due, for too long hangs.
  activity @0 :Activity;
  due @1 :Int64;
  # Running: since when. Asleep: the latest time of the next cycle, 0 if there is none. The responder's
  # steady clock, ns.
  cycles @2 :UInt64;  # so far

  enum Activity {
    running @0;
    asleep @1;
    suspended @2;
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
  frames @8 :Manager.Frames;  # what the required interface expects
  events @9 :UInt64;      # bit i: wants event i of the lock's
  notices @10 :Notices;   # how the caller learns what befalls the connection
  epoch @11 :Int64;
  # Higher for each connection that a required interface makes (the caller's steady clock, ns). A higher
  # one ends those before, whose commands may still be on their way; a lower one comes too late itself.
  # 0: neither.
  silence @12 :Int64;
  # How long the caller waits for an answer to a ping before it gives the provider up, ns. When as much has passed
  # since the responder sent what was last answered, it executes nothing of this connection any more. 0: for ever.
  lane @13 :Text;         # how the connection is to travel
  brings @14 :AnyPointer; # what that lane's client tells its provider; see the lane's own schema
}

struct ConnectResults {
  union {
    accepted :group {
      connection @0 :Connection;
      lacking @1 :List(UInt16);
      # The numbers of the caller's commands that the provider does not have: optional ones, or those of a newer contract.
      rows @2 :UInt32 = 64;
      # How many rows of state the provider keeps; so does the caller, of those that arrive.
      earlier @3 :Earlier;     # of the connections of the same name before
      answer @4 :AnyPointer;   # what the lane's provider tells its client
    }
    refused @5 :Manager.Refusal;
    declined @6 :Text;
    # Why this lane cannot be had for this connection: another one may.
  }
  failed @7 :Bool;
  # Declined because something went wrong that should not, as for want of a descriptor: both processes say so.
}

interface Notices {
  faulted @0 (reason :Text) -> ();
  # The provider's handler threw: its component is parked, the connection stands.
  closed @1 () -> ();
  # The provider has taken the connection down.
  suspended @2 () -> ();
  # The provider's component executes nothing until resumed() says so: its commands are refused.
  resumed @3 () -> ();
  lapsed @4 ();
  # The provider has heard nothing of the client for as long as the client waits, and executes nothing of this
  # connection any more: it has to be made anew.
  earlier @5 (earlier :Earlier) -> ();
  # The last word on the connections of the same name before.
  refused @6 (why :Text);
  # The provider's process has refused what came by the connection, which ends. why: in words.
}

struct Tally {
  # What has become of the commands of a connection that have reached the provider's end.
  executed @0 :UInt64;
  late @1 :UInt64;        # older than their ttl
  refused @2 :UInt64;
  failed @3 :UInt64;      # the handler threw
  replaced @4 :UInt64;    # a newer one of the same latest() command came first
  superseded @5 :UInt64;  # a later command had run already
  cancelled @6 :UInt64;
  eventsDropped @7 :UInt64;
}

struct Earlier {
  # Of all connections of the same name that the same two processes, not started anew since, had before.
  tally @0 :Tally;
  ended @1 :Bool;  # nothing of them is executed any more, so these are the last counts
}

interface Connection {
  # Lives as long as the connection: dropping it disconnects. It has no methods.
}
