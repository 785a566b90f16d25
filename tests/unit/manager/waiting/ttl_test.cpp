// The age of a command is judged when its turn comes: one that was new when a drain began may be
// too old behind a handler that takes long.

#include <gtest/gtest.h>

#include "support/pass.h"
#include "unit/manager/waiting/waiting_commands.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

class Ttl : public WaitingCommands {};

INSTANTIATE_TEST_SUITE_P(Lanes, Ttl, testing::ValuesIn(allWays()), nameOfWay);

TEST_P(Ttl, RunsOutBehindALongHandler) {
  SlowArm arm([] { pass(kTtl + 1ms); });
  send(arm);
  EXPECT_EQ(arm.servos, 0);
  EXPECT_EQ(late_, 1u);
}

TEST_P(Ttl, HoldsBehindAHandlerThatIsFaster) {
  SlowArm arm([] { pass(kTtl - 10ms); });
  send(arm);
  EXPECT_EQ(arm.servos, 1);
  EXPECT_EQ(late_, 0u);
}

// A command without a ttl runs behind it however long it takes, and the reports say how old it was.
TEST_P(Ttl, ReportsTheAgeBehindALongHandler) {
  SlowArm arm([] { pass(1s); });
  send(arm);
  EXPECT_GE(oldest_, 1s);
}

}  // namespace
}  // namespace suture
