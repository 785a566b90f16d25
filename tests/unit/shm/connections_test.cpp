// These tests say what becomes of connections that might share memory.
#include <gtest/gtest.h>

#include "reference/remote_arm.h"

namespace suture {
namespace {

using SharedConnections = RemoteArm;

TEST_F(SharedConnections, OnOneMachineAreTheFastest) {
  begin(unixAddress());
  connect();
  EXPECT_EQ(channel()->lane, "shm");
  EXPECT_EQ(channel()->terms.laneReason, "");
}

TEST_F(SharedConnections, CanBeDoneWithout) {
  begin(unixAddress());
  connect(Lane::Rpc);
  EXPECT_EQ(channel()->lane, "rpc");
  EXPECT_EQ(channel()->terms.laneReason, "");
}

TEST_F(SharedConnections, TcpFallsBackToFrames) {
  begin("tcp://127.0.0.1:0");
  connect(Lane::Shm);
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->terms.laneReason, "the two processes are not reached by a Unix socket");
}

TEST_F(SharedConnections, RefuseWhatIsOutOfRange) {
  begin(unixAddress());
  connect(Lane::Shm);
  expectArgumentsJudged();
}

TEST_F(SharedConnections, GiveEverythingBack) {
  begin(unixAddress());
  expectEverythingGivenBack(Lane::Shm);
}

}  // namespace
}  // namespace suture
