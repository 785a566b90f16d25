@0x89805522d1f349b0;
# The wire contract of loadable/parts.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("loadable::wire");
$Meta.header("loadable/parts.h");

struct PlatterParameters @0xf347ff700279ba69 $Meta.cxx("loadable::PlatterParameters") {
  angle @0 :Float64;
}

struct SpindleParameters @0xc40d3787b1d83361 $Meta.cxx("loadable::SpindleParameters") {
  cycles @0 :Int32 = 50;
  # until it seizes, again and again
  brake @1 :Text $Meta.capacity([255]);
  # the file that stands for it
  key @2 :Text $Meta.capacity([255]);
  # The file that lets it turn until it seizes, and that it takes away then; "": it turns anyway.
}
