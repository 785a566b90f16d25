// This runs the conformance suite over a lane that is not the runtime's.

#include <gtest/gtest.h>

#include "conformance/pipe/pipe_lane.h"
#include "conformance/rows.h"

int main(int argc, char** argv) {
  conformance::runOverAdded({"pipe", [] { return std::make_unique<conformance::PipeLane>(); }});
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
