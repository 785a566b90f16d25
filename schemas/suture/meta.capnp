@0x998f013c8ed6abfe;
# What a locked schema keeps and capnp itself cannot say. suturec writes and reads these; a change of
# those marked "break" is refused like a change of type.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire::meta");

annotation header @0xfa75b35d473ef8a4 (file) :Text;
# The annotated header that this schema locks.

annotation formerly @0x9f4be6a80d1c7352 (file) :Text;
# What this file called so, and where it is now: "Pose @0x9b87d70f9fe9600f /arm/arm.capnp:Placement".
# A schema that was locked before the move names it here. The first name is of another file if that is gone.

annotation cxx @0xd470381940aa15b6 (struct, enum, interface, field, enumerant, method, param) :Text;
# The C++ name: qualified on a type, plain elsewhere and then only where it is not the wire name.

annotation eventsOf @0xed0351d22393551e (interface) :Text;
# The C++ contract whose events these are.

annotation stateOf @0xfa7d5d07bcaf6abb (struct) :Text;
# The C++ contract whose read commands are the columns of this row.

annotation major @0xc4d1e09a7b35f628 (interface) :UInt32;
# How often the contract was broken on purpose, plus one; absent = 1. Peers of different majors refuse
# each other.

annotation unit @0x9cebc59597ba1262 (field, param) :Text;
# break. "m/s", "rad"...

annotation period @0xe93a33fae94d72c2 (field, param, method) :Text;
# break. Tick of the C++ duration in seconds, "1/1000"; the wire carries nanoseconds.

annotation clock @0xfdb2880c80660dd0 (field, param, method) :Text;
# break. "steady" or "system"; the wire carries nanoseconds since the clock's epoch.

annotation shape @0xbcaedc211610f446 (field, param, method) :Text;
# break. Fixed extents of lists, outside in: "*" open, "7" an array, "6x7" a matrix, column-major.

annotation range @0x94378331cf3a0f00 (field, param) :Range;
# The receiving end refuses what lies outside.

annotation capacity @0xb9153c2d27d33063 (field, param, method) :List(UInt32);
# Upper bounds of text and lists, outside in; 0 = unbounded.

annotation distinct @0xd8f5a03b6c1e9427 (field, param, method) :List(UInt32);
# The levels of lists that are sets, 0 the outermost: the receiving end refuses an element that is there twice.

annotation bulk @0xe60b8c2f94a7d135 (field, param, method) :Text;
# break. "Float64"...: the bytes are such numbers, little-endian, one behind the other.

annotation default @0xc2d6f0a91b7e4835 (field) :Text;
# The C++ default where it is not that of the schema, which keeps the first one.

annotation underlying @0xaa6a851ab778967e (enum) :Text;
# The C++ underlying type of an enum.

annotation value @0x91c39e75d52c17cd (enumerant) :Int64;
# The C++ value; the wire carries the ordinal.

annotation fallback @0xf768064f958507ad (enumerant) :Void;
# Stands for the enumerators that a receiver does not know; absent = it refuses them.

annotation kind @0xf2076aea88bf178f (method) :Text;
# break. Of a command: "void", "write", "read", "qualifiedRead".

annotation queue @0x8aba1b3df2bda459 (method) :UInt32;
# How many may wait.

annotation latest @0xc849b8fe6fa70774 (method) :Void;
# A newer one replaces the waiting one.

annotation ttl @0xa9274b46a0b5d1f3 (method) :Int64;
# Nanoseconds after which a waiting command is discarded.

annotation deadline @0xc9d7bd12c2be7f41 (method) :Int64;
# Nanoseconds that a caller waits for the answer when it does not say otherwise.

annotation optional @0xb6f1b4d0a4f4a6a8 (field, method) :Void;
# A provider may lack it.

annotation concurrent @0xd8f27cc9a1f5a3b6 (method) :Void;
# May run while the component runs.

annotation direct @0xae3e7dd9f1c64d27 (method) :Void;
# Needs no queue.

annotation version @0xf5d6a4cd23f0b9c4 (interface) :UInt32;
# break. The major version of the contract where it is not 1.

annotation latched @0xe2f9c1d7b8405a6e (method) :Void;
# A late subscriber receives the last value.

annotation since @0xb1c95e7f02d48a63 (struct, enum, interface, field, enumerant, method) :UInt32;
# The version that it came with.

annotation deprecated @0xcf4a1d8e57b63092 (struct, enum, interface, field, enumerant, method) :Text;
# Why it should not be used any more.

annotation removed @0xd3b1f04c6a8e9275 (struct, enum, interface, field, enumerant, method) :Text;
# No longer declared; keeps its place for ever. The argument is its last name on the wire.

struct Range @0xb7c2e85d1f9a6043 {
  lowest @0 :Float64;
  highest @1 :Float64;
}
