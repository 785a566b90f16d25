@0x8e1d692c22b8357c;
# The global manager: the process that knows names. It hands out addresses and nothing else; peers talk
# to each other directly (peer.capnp).

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

const protocolVersion :UInt16 = 7;
# It counts the changes of manager.capnp, peer.capnp, what lanes say (calls, frame, shm), frames and shared memory. Both sides say theirs in hello; a difference
# is a refusal.

const renewalMilliseconds :UInt32 = 500;
# How often a lease is renewed.

const missableRenewals :UInt16 = 4;
# A process that misses more of them is silent: its name is not handed out, and is free for another.

struct Refusal {
  # Why something did not happen, for a program and for a person.
  kind @0 :Kind;
  text @1 :Text;  # what was asked, what was found, what to do

  enum Kind {
    versionMismatch @0;
    nameTaken @1;
    noSuchProcess @2;
    noSuchComponent @3;
    noSuchInterface @4;
    contractMismatch @5;  # of contracts or frames
    alreadyConnected @6;
    timedOut @7;
    malformed @8;
    notReady @9;
    noHello @10;
    limitReached @11;
    notPermitted @12;
  }
}

struct InterfaceRecord {
  name @0 :Text;      # "Arm"
  contract @1 :Text;  # "robots::Arm"
  hash @2 :Text;      # of the wire contract; equal hashes are compatible
  frames @3 :Frames;
}

struct Frames {
  # The coordinate frames that an interface declares. None: not declared, and not compared.
  reference @0 :Text;  # in which its poses are given
  moving @1 :Text;     # whose poses they are
}

struct ComponentRecord {
  name @0 :Text;
  provided @1 :List(InterfaceRecord);
  required @2 :List(InterfaceRecord);
}

struct ProcessRecord {
  name @0 :Text;
  addresses @1 :List(Text);  # "unix:/path" or "tcp://host:port", best first
  pid @2 :Int32;
  host @3 :Text;
  components @4 :List(ComponentRecord);
  generation @5 :UInt64;  # given by the manager: a name registered again has a higher one
  silent @6 :Bool;  # given by the manager: the lease has not been renewed in time
}

interface GlobalManager {
  hello @0 (version :UInt16, program :Text) -> HelloResults;
  # First. Everything else is reached through the session that it returns.
  struct HelloResults {
    union {
      session @0 :Session;
      refused @1 :Refusal;
    }
  }
}

interface Session {
  register @0 (process :ProcessRecord) -> RegisterResults;
  # The name is held as long as the lease is: dropping it, or losing the connection, frees the name. A
  # process that misses more than missableRenewals of its lease is silent.
  struct RegisterResults {
    generation @0 :UInt64;
    union {
      lease @1 :Lease;
      refused @2 :Refusal;
    }
  }

  resolve @1 (process :Text, waitMilliseconds :UInt32) -> ResolveResults;
  # Answers when the process is there and not silent, or with a refusal after the wait (which the
  # manager bounds).
  struct ResolveResults {
    union {
      found @0 :ProcessRecord;
      refused @1 :Refusal;
    }
  }

  list @2 (after :Text) -> (processes :List(ProcessRecord), more :Bool);
  # In the order of their names, those behind `after`; as many as fit into one answer, of which there is
  # another behind the last if there are more.
}

interface Lease {
  update @0 (components :List(ComponentRecord)) -> ();
  # Replaces what the process offers and needs.

  renew @1 () -> (held :Bool);
  # Tells that the process lives. Not held: the name has gone to another process meanwhile.
}
