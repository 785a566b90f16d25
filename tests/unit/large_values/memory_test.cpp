// The memory that connections take is bounded for each peer, and is given back.

#include <gtest/gtest.h>
#include <suture/base/sanitizers.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/session/provider/limits/channel_memory.h>

#include <string>
#include <vector>

#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/large_values/hall.suture.h"
#include "unit/large_values/lanes.h"
#include "unit/large_values/museum.h"

namespace large_values {
namespace {

using suture::ChannelMemory, suture::contains, suture::Lane;

struct HallDevice final : suture::Device, Hall {
  void fill(const Picture&) override {}
  suture::Provided<Hall> hall{*this, "Hall", *this};
};

struct Decorator final : suture::Device {
  suture::Required<Hall> hall{*this, "Hall"};
};

class MemoryOfConnectionsBy : public testing::TestWithParam<Lane> {
 protected:
  MemoryOfConnectionsBy() {
    for (suture::Manager* const one : {&museum_, &town_}) addEncodedLane(*one);
    museum_.add("Wall", wall_);
    museum_.add("Castle", castle_);
    museum_.start();
    town_.add("Visitor", visitor_);
    town_.add("Decorator", decorator_);
    town_.start();
  }
  ~MemoryOfConnectionsBy() override {
    town_.stop();
    museum_.stop();
  }
  void connect(const char* from, const char* to) {
    town_.connect(from, to, {.lane = GetParam(), .laneRequired = true});
  }

  const suture::TemporaryDirectory directory_;
  WallTask wall_;
  HallDevice castle_;
  Visitor visitor_;
  Decorator decorator_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager museum_{"museum", names_.address()}, town_{"town", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(EachLane, MemoryOfConnectionsBy,
                         testing::Values(Lane::Shm, Lane::Frame, kEncoded, Lane::Rpc), nameOf);

TEST_P(MemoryOfConnectionsBy, IsRefusedBeyondThePeersShare) {
  connect("Visitor/Gallery", "museum:Wall/Gallery");
  const std::string refused =
      suture::refusal([this] { connect("Decorator/Hall", "museum:Castle/Hall"); });
  EXPECT_TRUE(contains(refused, "use 'museum:Castle/Hall': the connection would take 214"))
      << refused;
  EXPECT_TRUE(contains(refused, " bytes, and of the 2147483648 for the connections of user "))
      << refused;
  EXPECT_FALSE(contains(refused, " 2147483648 are left")) << "the picture's connection counts";
  EXPECT_TRUE(contains(
      refused, " are left. Let go of some, or give its commands and events shorter queues."))
      << refused;
  EXPECT_EQ(museum_.refusals().count, 1u);
  EXPECT_TRUE(contains(museum_.refusals().latest, "use 'museum:Castle/Hall': the connection would"))
      << museum_.refusals().latest;
  EXPECT_TRUE(visitor_.gallery.hang.start(grey(20)).within(suture::kPatience).has_value())
      << "what is connected goes on";
}

// The provider would need more than 2 GiB if it kept what is over.
TEST_P(MemoryOfConnectionsBy, IsGivenBack) {
  for (int lap = 0; lap < 60; ++lap) {
    ASSERT_TRUE(suture::eventually([this] {
      return suture::refusal([this] { connect("Visitor/Gallery", "museum:Wall/Gallery"); }) == "";
    })) << lap;
    town_.disconnect("Visitor/Gallery");
  }
}

#ifndef SUTURE_THREAD_SANITIZER  // which takes four times the 5 GB that this needs besides
/// Returns how many of the visitors find room at the device before its peer's memory is full.
int fill(suture::Manager& town, std::size_t visitors) {
  int connected = 0;
  for (std::size_t one = 0; one < visitors; ++one) {
    const std::string name = "Visitor" + std::to_string(one) + "/Gallery";
    const std::string refused =
        suture::refusal([&] { town.connect(name, "museum:Panel/Gallery", {.lane = Lane::Frame}); });
    if (!refused.empty()) break;
    ++connected;
  }
  for (int one = 0; one < connected; ++one) {
    town.disconnect("Visitor" + std::to_string(one) + "/Gallery");
  }
  return connected;
}

// A device has no cycle in which it would let go of the connections that have ended.
TEST(MemoryOfConnectionsToADevice, IsGivenBackOnceFull) {
  const suture::TemporaryDirectory directory;
  WallDevice panel;
  std::vector<Visitor> visitors(60);
  suture::loop::ControlThread control;
  const suture::GlobalManager names(control, "unix:" + directory.file("m.sock"));
  suture::Manager museum("museum", names.address()), town("town", names.address());
  museum.add("Panel", panel);
  museum.start();
  for (std::size_t one = 0; one < visitors.size(); ++one) {
    town.add("Visitor" + std::to_string(one), visitors[one]);
  }
  town.start();
  const int room = fill(town, visitors.size());
  EXPECT_LT(room, 60) << "the memory is full before all have come";
  EXPECT_TRUE(suture::eventually([&] { return fill(town, visitors.size()) == room; }));
  town.stop();
  museum.stop();
}
#endif

class MemoryOfConnections : public testing::Test {
 protected:
  suture::ChannelMemory::Share held(const std::string& peer, std::size_t bytes) {
    auto share = memory_.share(peer);
    EXPECT_FALSE(memory_.hold(share, bytes));
    return share;
  }
  ChannelMemory memory_{{.peer = 100, .process = 150}};
};

TEST_F(MemoryOfConnections, IsCountedForEachPeer) {
  auto first = held("first", 60);
  const auto more = memory_.share("first");
  const auto beyond = memory_.hold(more, 41);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->whose, "first");
  EXPECT_EQ(beyond->limit, 100u);
  EXPECT_EQ(beyond->left, 40u);
  EXPECT_FALSE(memory_.hold(more, 40)) << "a refusal takes nothing";
  const auto other = held("other", 50);
  first = nullptr;
  EXPECT_FALSE(memory_.hold(more, 100));
}

TEST_F(MemoryOfConnections, IsCountedForAllPeersTogether) {
  const auto first = held("first", 100), second = held("second", 40);
  const auto beyond = memory_.hold(memory_.share("third"), 11);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->whose, "all peers");
  EXPECT_EQ(beyond->left, 10u);
}

}  // namespace
}  // namespace large_values
