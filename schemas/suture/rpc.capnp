@0xa621ff1bb11163d2;
# What every generated contract schema shares.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

struct Subscription {
  # The parameters of `subscribe`, method 0 of every contract; a later call replaces an earlier one. The generated schemas leave
  # joinMask out: a program that knows only these leaves an event, and joins it again, with two calls.
  events @0 :Capability;   # receives them: of the contract's events interface
  eventMask @1 :UInt64;    # bit i: event i
  stateMask @2 :UInt64;    # bit i: column i
  joinMask @3 :UInt64;     # of the events: those that are wanted anew, the last value first if they are latched; so are
                           # those that were not wanted before
}

struct Sent {
  # Travels with every command. A client that says nothing of it is served all the same.
  stamp @0 :Int64;   # the sender's steady clock when it sent, ns; 0: not said
  answer @1 :Bool;   # return when the command has been executed, and tell how that ended; without it a
                     # queued command returns when the provider has taken it, a latest() one at once
}
