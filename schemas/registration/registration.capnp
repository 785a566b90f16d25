@0xe76a27c21b348193;
# The wire contract of registration/registration.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Rpc = import "/suture/rpc.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("registration/registration.h");

struct SceneFrames @0xe63e7e972f06e442 $Meta.cxx("robots::SceneFrames") {
  # Says where things are: slaves and camera in the frame of the scene, whose z points away from the
  # tissue; masters and display in that of the console. The place of an arm is that of the reference
  # frame in which it gives its poses, which is its base unless set_base_frame() has moved it.

  leftBase @0 :Types.Pose $Meta.cxx("left_base") $Meta.unit("m");
  rightBase @1 :Types.Pose $Meta.cxx("right_base") $Meta.unit("m");
  camera @2 :Types.Pose $Meta.unit("m");
  # The left camera is here, with x to the right and y downward in the image, z ahead.
  tissue @3 :Float64 = -0.16 $Meta.unit("m");
  # The tissue's surface has this z.
  leftMaster @4 :Types.Pose $Meta.cxx("left_master") $Meta.unit("m");
  rightMaster @5 :Types.Pose $Meta.cxx("right_master") $Meta.unit("m");
  display @6 :Types.Pose $Meta.unit("m");
  # The surgeon looks at a picture here, with the axes of the camera: x to the right and y
  # downward in it, z ahead.
}

interface Registration @0xe9484f8fbd271c3f $Meta.cxx("robots::Registration") {
  # Commands run in the registration's own thread.

  subscribe @0 (events :RegistrationEvents, eventMask :UInt64, stateMask :UInt64) -> ();
  # Bit i of eventMask asks for event i, bit i of stateMask for column i; a later call replaces an earlier one.
  frames @1 (sent :Rpc.Sent) -> (value :SceneFrames, stamp :Int64) $Meta.kind("read");
  # Returns the frames as they were registered last; each rotation is one to 1e-6. Ask with
  # `frames.at(stamp)` for those to which an image or a pose of that stamp belongs.
  setCamera @2 (camera :Types.Pose $Meta.unit("m"), sent :Rpc.Sent) -> () $Meta.cxx("set_camera")
      $Meta.kind("write") $Meta.queue(16);
  # Says that the left camera has been moved there. It is ignored, with a warning, unless its
  # rotation is one.
}

interface RegistrationEvents @0xead83c2c10b9a601 $Meta.eventsOf("robots::Registration") {
  # What a subscriber of Registration receives.

  state @0 (row :RegistrationStateRow) -> ();
  # A new row of the columns asked for.
}

struct RegistrationStateRow @0xf672b219e7b88cf8 $Meta.stateOf("robots::Registration") {
  # One row of the state table: what the read commands of Registration answer.

  stamp @0 :Int64;
  # When the row was written: the provider's steady clock, ns.
  evaluated @1 :UInt64;
  # Bit i: column i was evaluated.
  tooLarge @2 :UInt64;
  # Bit i: column i did not fit its declared capacity.
  frames @3 :SceneFrames;
}
