// These tests say what the connections of a session share, on each lane and at each kind of
// address.

#include <gtest/gtest.h>

#include "reference/remote_arm.h"

namespace suture {
namespace {

struct Way {
  const char* name;
  const char* address;  ///< "": a Unix socket
  Lane lane;
};

class Sharing : public RemoteArm, public testing::WithParamInterface<Way> {
 protected:
  static constexpr std::size_t kMore = 8;
  /// A connection by `shm` has this much memory in both processes: the client maps queues, rows and
  /// the provider's doorbell, the provider queues and the client's doorbell. The ledger keeps the
  /// counters of one that is closed, and so the queues that they lie beside.
  const std::size_t standing = GetParam().lane == Lane::Shm ? 5 : 0;
  const std::size_t closed = GetParam().lane == Lane::Shm ? 2 : 0;

  void beginAtAddress() { begin(*GetParam().address == '\0' ? unixAddress() : GetParam().address); }
  void beginWithOthers() {
    for (std::size_t i = 0; i < kMore; ++i) others.push_back(std::make_unique<Teleop>());
    beginAtAddress();
    connect(GetParam().lane);
  }
  void connectOthers() {
    for (std::size_t i = 0; i < kMore; ++i) {
      console->connect(nameOf(i), "robot:PSM/Arm", {.lane = GetParam().lane});
      ASSERT_TRUE(eventually([&] { return others[i]->seen.load(); })) << i;
    }
  }
  static std::string nameOf(std::size_t i) { return "Other" + std::to_string(i) + "/Slave"; }
};

INSTANTIATE_TEST_SUITE_P(Lanes, Sharing,
                         testing::Values(Way{"Shm", "", Lane::Shm}, Way{"Frame", "", Lane::Frame},
                                         Way{"FrameTcp", "tcp://127.0.0.1:0", Lane::Frame},
                                         Way{"FrameTls", "tls://127.0.0.1:0", Lane::Frame},
                                         Way{"Rpc", "", Lane::Rpc},
                                         Way{"RpcTcp", "tcp://127.0.0.1:0", Lane::Rpc},
                                         Way{"RpcTls", "tls://127.0.0.1:0", Lane::Rpc}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Sharing, EachEndKeepsItsOwnAges) {
  beginAtAddress();
  connect(GetParam().lane);
  ASSERT_TRUE(eventually([&] { return teleop.seen.load(); }));
  const auto provider = robot->channels().at(0);
  EXPECT_NE(channel()->client.readAge, nullptr);
  EXPECT_EQ(channel()->provider.commandAge, nullptr);
  EXPECT_EQ(provider->client.readAge, nullptr);
  EXPECT_NE(provider->provider.commandAge, nullptr);
}

/// Both ends of each socket are in this process.
TEST_P(Sharing, MoreConnectionsNeedNoMoreSockets) {
  beginWithOthers();
  const std::size_t before = openSockets(), memory = openMemory();
  connectOthers();
  EXPECT_EQ(openSockets(), before);
  if (GetParam().lane != Lane::Shm) {
    EXPECT_EQ(openMemory(), memory);
  }
  for (const auto& one : console->channels()) {
    EXPECT_EQ(one->lane, toString(GetParam().lane)) << one->terms.laneReason;
  }
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_P(Sharing, TakingOneDownLeavesTheOthers) {
  beginWithOthers();
  connectOthers();
  console->disconnect("Teleop/Slave");
  ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
  for (const auto& one : others) EXPECT_TRUE(one->reachable);
  connect(GetParam().lane);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

// The session stands, and no client connects anew. The test counts memory from before the first
// connection, since descriptors that messages bring are open for a while longer than the connection
// takes.
TEST_P(Sharing, TakenDownOnesReturnWhatTheyHeld) {
  for (std::size_t i = 0; i < kMore; ++i) others.push_back(std::make_unique<Teleop>());
  beginAtAddress();
  const std::size_t without = openMemory();
  connect(GetParam().lane);
  connectOthers();
  for (std::size_t i = 0; i < kMore; ++i) console->disconnect(nameOf(i));
  constexpr std::size_t kRows = 1;  // which the provider makes for its first client, and keeps
  EXPECT_TRUE(eventually([&] {
    return openMemory() == without + kRows + standing + kMore * closed;
  })) << openMemory()
      << ", without a connection " << without;
  EXPECT_EQ(outcomeOf(0.5), Errc{});
}

TEST_P(Sharing, TheLastOneEndsItsSession) {
  beginAtAddress();
  const std::size_t without = openSockets();
  for (int lap = 0; lap < 3; ++lap) {
    connect(GetParam().lane);
    EXPECT_GT(openSockets(), without);
    console->disconnect("Teleop/Slave");
    EXPECT_TRUE(eventually([&] { return openSockets() == without; })) << openSockets();
  }
}

TEST_P(Sharing, TheNextProcessGetsAllBack) {
  beginWithOthers();
  connectOthers();
  const std::size_t before = openSockets();
  restartRobot();
  EXPECT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  for (const auto& one : others) EXPECT_TRUE(eventually([&] { return one->reachable.load(); }));
  EXPECT_TRUE(eventually([&] { return openSockets() <= before; })) << openSockets();
  for (const auto& one : console->channels()) {
    EXPECT_EQ(one->lane, toString(GetParam().lane)) << one->terms.laneReason;
  }
}

}  // namespace
}  // namespace suture
