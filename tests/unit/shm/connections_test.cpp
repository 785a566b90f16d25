// These tests say what becomes of connections that might share memory.
#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>

#include <memory>
#include <string>

#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/no_more_descriptors.h"

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

// Both ends are in this process, and each remembers what every connection has counted.
TEST_F(SharedConnections, GiveTheMemoryOfManyNamesBack) {
  for (int i = 0; i < 40; ++i) others.push_back(std::make_unique<Teleop>());
  begin(unixAddress());
  connect(Lane::Shm);
  const std::size_t before = openMemory();
  for (std::size_t i = 0; i < others.size(); ++i) {
    const std::string client = "Other" + std::to_string(i) + "/Slave";
    console->connect(client, "robot:PSM/Arm", {.lane = Lane::Shm});
    ASSERT_TRUE(eventually([&] { return others[i]->reachable.load(); }));
    console->disconnect(client);
    ASSERT_TRUE(eventually([&] { return !others[i]->reachable; }));
  }
  EXPECT_LE(openMemory(), before + 6) << "those that ended last may still go";
}

#ifndef SUTURE_ADDRESS_SANITIZER  // UBSan opens a pipe to judge a type that it meets first
// The process has one descriptor table for both ends, and the socket of frames stands already.
TEST_F(SharedConnections, AMissingDescriptorIsTold) {
  others.push_back(std::make_unique<Teleop>());
  begin(unixAddress());
  console->connect("Other0/Slave", "robot:PSM/Arm", {.lane = Lane::Frame});
  connect(Lane::Shm);
  console->disconnect("Teleop/Slave");
  ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
  testing::internal::CaptureStderr();
  {
    const NoMoreDescriptors limit;
    connect(Lane::Shm);
  }
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(contains(told, "robot: refused user ")) << told;
  EXPECT_TRUE(contains(told, ": use 'robot:PSM/Arm' by lane 'shm': ")) << told;
  EXPECT_TRUE(contains(told,
                       "console: console:Teleop/Slave -> robot:PSM/Arm cannot travel by lane "
                       "'shm': "))
      << told;
  EXPECT_EQ(robot->refusals().count, 1u);
  for (const auto& one : console->channels()) EXPECT_EQ(one->lane, "frame") << told;
}
#endif

}  // namespace
}  // namespace suture
