@0x936a19b350ff9785;
# The wire contract of surgeon/operator.h, written by suturec --update-lock: commit it, never edit it.

using Cxx = import "/capnp/c++.capnp";
using Meta = import "/suture/meta.capnp";
using Types = import "/suture/types.capnp";
$Cxx.namespace("robots::wire");
$Meta.header("surgeon/operator.h");

struct OperatorParameters @0xaf56e73ffd937125 $Meta.cxx("robots::OperatorParameters") {
  period @0 :Int64 = 1000000 $Meta.period("1/1000000000");
  target @1 :Types.Vec3 $Meta.unit("m");
  # The knot shall come here, in the scene.
  scale @2 :Float64 = 0.4 $Meta.range(lowest = 0.01, highest = 10);
  # The knot moves this far for a metre of both hands: the scale of the guide, to which operators
  # adapt themselves.
  crossoverFrequency @3 :Float64 = 3.0 $Meta.cxx("crossover_frequency")
      $Meta.range(lowest = 0.1, highest = 20) $Meta.unit("rad/s");
  # This and the next three are those of McRuer's model (surgeon/crossover_model.h).
  delay @4 :Int64 = 200000000 $Meta.period("1/1000000000");
  # This time passes from seeing to moving; it is not below zero.
  remnant @5 :Float64 = 0.01 $Meta.range(lowest = 0, highest = 1);
  # What is seen has noise. This is its power in each rad/s, divided by the power of the error.
  seed @6 :UInt32 = 1;
  # Equal seeds and pictures give equal noise and tremor.
  tremor @7 :Float64 = 0.0001 $Meta.range(lowest = 0, highest = 0.002) $Meta.unit("m");
  # Each hand's tremor has this root mean square (hand/tremor.h).
  speed @8 :Float64 = 0.2 $Meta.range(lowest = 0.001, highest = 1) $Meta.unit("m/s");
  # The hands go no faster, whatever the error: our own estimate of careful work.
  pictureAge @9 :Int64 = 1000000000 $Meta.cxx("picture_age") $Meta.period("1/1000000000");
  # The operator does not act on a picture that was exposed longer ago, nor if its camera was
  # registered so long before it.
  forceFeedback @10 :ForceFeedback $Meta.cxx("force_feedback");
  # Says what the hands feel of the slaves.
  stiffness @11 :Float64 = 300.0 $Meta.range(lowest = 0, highest = 5000) $Meta.unit("N/m");
  # Each master is drawn this stiffly, and damped this much, to where its slave is known to be.
  damping @12 :Float64 = 3.0 $Meta.range(lowest = 0, highest = 100) $Meta.unit("N.s/m");
  passive @13 :Bool = true;
  # If it is true, the passivity controller works; without it, hands may get more energy than they
  # gave.
  slaveAge @14 :Int64 = 300000000 $Meta.cxx("slave_age") $Meta.period("1/1000000000");
  # A slave that was measured longer ago is not felt, nor is what was forbidden longer ago.
  feelFixtures @15 :Bool $Meta.cxx("feel_fixtures");
  # If it is true, each hand also feels what the guide's fixtures forbid it
  # (force_feedback/fixture_resistance.h): they resist it with so much for each m/s.
  resistance @16 :Float64 = 60.0 $Meta.range(lowest = 0, highest = 1000) $Meta.unit("N.s/m");
}

enum ForceFeedback @0x9ef5532985c8a260 $Meta.cxx("robots::ForceFeedback") $Meta.underlying("UInt8") {
  none @0 $Meta.cxx("None") $Meta.value(0);
  positionPosition @1 $Meta.cxx("PositionPosition") $Meta.value(1);
  # force_feedback/position_position.h
}
