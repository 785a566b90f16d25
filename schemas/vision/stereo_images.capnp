@0x85972bb5bdae1f06;
# The wire contract of vision/stereo_images.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Vision = import "/robot_types/vision.capnp";
using Rpc = import "/suture/rpc.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("vision/stereo_images.h");

struct StereoPair @0xc5ad7542a285d330 $Meta.cxx("robots::StereoPair") {
  # Holds two rectified images of one moment; both stamps are that of the exposure.

  left @0 :Vision.ImageFrame;
  right @1 :Vision.ImageFrame;
}

interface StereoImages @0xefa57eee714fcf37 $Meta.cxx("robots::StereoImages") {
  subscribe @0 (events :StereoImagesEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  images @1 (sent :Rpc.Sent) -> (value :StereoPair, stamp :Int64) $Meta.kind("read");
  # Returns the last pair; it is not valid while there is nothing to see.
  exposed @2 (sent :Rpc.Sent) -> (value :Int64 $Meta.clock("steady"), stamp :Int64)
      $Meta.kind("read");
  # Returns the stamp of the last pair, and 0 while there is nothing to see. A client that asks
  # this first copies megabytes only if they are new.
}

interface StereoImagesEvents @0xed57a378bacd9ffb $Meta.eventsOf("robots::StereoImages") {
  # What a subscriber of StereoImages receives.

  state @0 (row :StereoImagesStateRow) -> ();
  # A new row of the columns asked for.
}

struct StereoImagesStateRow @0xe5a2d9c7d98a1e0c $Meta.stateOf("robots::StereoImages") {
  # One row of the state table: what the read commands of StereoImages answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  images @3 :StereoPair;
  exposed @4 :Int64 $Meta.clock("steady");
}
