@0x883973b49c29faaa;
# The wire contract of guidance/knot_guide.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("guidance/knot_guide.h");

struct GuideParameters @0xc5a448822c5a8c36 $Meta.cxx("robots::GuideParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  scale @1 :Float64 = 0.4 $Meta.range(lowest = 0.01, highest = 10);
  # A slave moves this many metres for each metre of its master.
  maxAge @2 :Int64 = 20000000 $Meta.cxx("max_age") $Meta.period("1/1000000000");
  # If an arm's data are older than this, both slaves hold.
  sightingAge @3 :Int64 = 250000000 $Meta.cxx("sighting_age") $Meta.period("1/1000000000");
  # What the cameras saw has the same kind of bound: some three images.
  fixtures @4 :Bool = true;
  # If it is false, the slaves follow their masters wherever the knot is.
  target @5 :Types.Vec3 $Meta.unit("m");
  # The knot shall come here, in the scene.
  approach @6 :Types.Vec3;
  # It shall come there in this direction, of any length but zero.
  radius @7 :Float64 = 0.0003 $Meta.range(lowest = 1e-04, highest = 0.1) $Meta.unit("m");
  # The corridor has this radius at the target, and widens by this slope before that.
  slope @8 :Float64 = 0.3 $Meta.range(lowest = 0, highest = 1);
  speed @9 :Float64 = 0.1 $Meta.range(lowest = 0.001, highest = 1) $Meta.unit("m/s");
  # A tip may move this fast along each axis.
  separation @10 :Float64 = 0.01 $Meta.range(lowest = 0, highest = 0.1) $Meta.unit("m");
  # The tips may come this near to each other.
  removed11 @11 :Float64 = -0.16 $Meta.range(lowest = -1, highest = 1) $Meta.removed("floor")
      $Meta.unit("m");
  enableAtStart @12 :Bool = true $Meta.cxx("enable_at_start");
  # If it is true, the guide prepares and guides without waiting for enable().
  registrationAge @13 :Int64 = 250000000 $Meta.cxx("registration_age") $Meta.period("1/1000000000");
  # Guiding does not begin with a registration that was renewed longer ago than this, and a
  # sighting does not count if its camera was registered that long before it. Guiding goes on with
  # the registration with which it began.
  operatorAge @14 :Int64 = 200000000 $Meta.cxx("operator_age") $Meta.period("1/1000000000");
  # If pedals or presence are older than this, they are not known, and both slaves hold.
  friction @15 :Float64 = 0.15 $Meta.range(lowest = 0, highest = 1);
  # Strand on strand has this coefficient of friction, by which the knot holds.
  wrap @16 :Float64 = 9.42 $Meta.range(lowest = 0, highest = 100) $Meta.unit("rad");
  # The strand winds about itself by this angle in the knot.
  preparationLimit @17 :Int64 = 60000000000 $Meta.cxx("preparation_limit")
      $Meta.period("1/1000000000");
  # If the arms and the registration are not ready after this time, the guide is disabled. With 0
  # it waits for ever.
  masterDamping @18 :Float64 $Meta.cxx("master_damping") $Meta.range(lowest = 0, highest = 1000)
      $Meta.unit("N.s/m");
  # Each master presses against its hand with so much for each m/s that the fixtures forbid it,
  # and floats in its hand while a pedal takes it from its slave. That is for a master that a hand
  # moves and whose drives control efforts, because body_servo_cf ends every other stream. With 0
  # the masters get no forces.
}
