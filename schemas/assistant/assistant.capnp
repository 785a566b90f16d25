@0xc944536c94628d64;
# The wire contract of assistant/assistant.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("assistant/assistant.h");

struct AssistantParameters @0xbd0af4013de1de7e $Meta.cxx("robots::AssistantParameters") {
  period @0 :Int64 = 10000000 $Meta.period("1/1000000000");
  pressAfter @1 :Int64 $Meta.cxx("press_after") $Meta.period("1/1000000000");
  # The assistant presses the stop this long after it has released the first one; 0 means never.
  releaseAfter @2 :Int64 = 1000000000 $Meta.cxx("release_after") $Meta.period("1/1000000000");
  # It releases what it has pressed this much later.
  patience @3 :Int64 = 500000000 $Meta.period("1/1000000000");
  # It enables what has waited for its arms for this long since they lost their power, and brings
  # up what has failed to come up for this reason, with power permitted. A person would look
  # first. What stops within two seconds of such a loss has stopped by it.
}
