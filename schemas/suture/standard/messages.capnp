@0xddb3e72e2708e464;
# The wire contract of suture/standard/messages.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("suture::wire");
$Meta.header("suture/standard/messages.h");

struct Message @0xbd6bc34f74980c5d $Meta.cxx("suture::Message") {
  text @0 :Text $Meta.capacity([255]);
  # The text is UTF-8, for people. A sender cuts a longer text, and ends it in "..." then.
  code @1 :UInt32;
  # Says what it is about, by numbers that its sender documents; 0 means nothing in particular.
  counter @2 :UInt32;
  # Counts the messages of its sender, of all three kinds together, from 1. A gap says that the
  # listener has missed some; a number seen before says that the last one was sent again.
  stamp @3 :Int64 $Meta.clock("steady");
}

interface Messages @0xb16d80f0d2b50980 $Meta.cxx("suture::Messages") {
  # Any component may provide this (message_port.h), and any contract may derive from it (then
  # message_sender.h sends); a client that listens to messages can connect to both. Each client
  # keeps up to 16 of a kind that it has not handled; more are dropped and counted. A client that
  # comes late gets the last of each kind.

  subscribe @0 (events :MessagesEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
}

interface MessagesEvents @0xa02813b154cdd1d8 $Meta.eventsOf("suture::Messages") {
  # What a subscriber of Messages receives.

  state @0 (row :MessagesStateRow) -> ();
  # A new row of the columns asked for.
  status @1 (value :Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something has been done, and nothing is wrong.
  warning @2 (value :Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something was refused, or is not as it should be; the component goes on.
  error @3 (value :Message, stamp :Int64) -> () $Meta.latched $Meta.queue(16);
  # Reports that something failed, and needs somebody's attention.
}

struct MessagesStateRow @0x814f9864e019fa96 $Meta.stateOf("suture::Messages") {
  # One row of the state table: what the read commands of Messages answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
}
