#include <suture/loop/kj_comparisons.h>  // first

#include <gtest/gtest.h>
#include <suture/lane/rpc/turn_ring.h>

#include "support/patience.h"

namespace suture::rpc {
namespace {

TEST(TurnRing, RingsForTheFirstAndAfterMany) {
  loop::ControlThread control;
  control.run(kPatience, [&control] {
    struct Counted {
      unsigned rings = 0;
      TurnRing ring;
      explicit Counted(loop::ControlThread& control) : ring(control, [this] { ++rings; }) {}
    };
    auto counted = kj::heap<Counted>(control);
    counted->ring.arrived();
    EXPECT_EQ(counted->rings, 1u) << "nothing waits for what comes behind it";
    for (unsigned i = 1; i < 2 * TurnRing::kTogether; ++i) counted->ring.arrived();
    EXPECT_EQ(counted->rings, 2u);
    auto turnsEnd = control.timer().afterDelay(0 * kj::NANOSECONDS);
    return turnsEnd
        .then([&counted = *counted] {
          EXPECT_EQ(counted.rings, 3u) << "for those behind the last ring";
          counted.ring.arrived();
          EXPECT_EQ(counted.rings, 4u) << "another turn has begun";
        })
        .attach(kj::mv(counted));
  });
}

}  // namespace
}  // namespace suture::rpc
