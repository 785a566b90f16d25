@0xc2e65139e6c77bcd;
# The wire contract of vision/knot_tracker.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/knot_tracker.h");

struct TrackerParameters @0xbb998047e1f73ec4 $Meta.cxx("robots::TrackerParameters") {
  period @0 :Int64 = 10000000 $Meta.default("20000000") $Meta.period("1/1000000000");
  # It looks for new images, and publishes poses, once in this period.
  maxAge @1 :Int64 = 250000000 $Meta.cxx("max_age") $Meta.period("1/1000000000");
  # A pose is not valid if it was seen longer ago than this: some three images.
  acceleration @2 :Float64 = 0.1 $Meta.range(lowest = 0.001, highest = 100) $Meta.unit("m/s2");
  # The velocity of what it follows changes this fast. This is our own number: that of a careful
  # hand.
}
