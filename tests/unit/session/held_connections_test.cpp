// A session holds so many connections of its peer, and no longer than they or it last.

#include <gtest/gtest.h>
#include <suture/session/provider/connections/held_connections.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/played_channel.h"
#include "shared_scene.h"
#include "support/contains.h"

namespace suture {
namespace {

struct PlayedEnd final : ProviderEnd {
  explicit PlayedEnd(std::shared_ptr<Channel> channel) : ProviderEnd(std::move(channel)) {}
};

const Endpoint kArm{"robot", "PSM", "Arm"};

class HeldConnectionsTest : public SharedScene {
 protected:
  void SetUp() override {
    SharedScene::SetUp();
    there([this] {
      held_ = std::make_unique<HeldConnections>(*shared_, "user 1", std::make_shared<PeerState>());
    });
  }
  void TearDown() override {
    there([this] {
      held_->end();
      held_.reset();
      rooms_.clear();
    });
    SharedScene::TearDown();
  }

  /// Makes a connection as a lane would, and returns its end.
  kj::Own<ProviderEnd> connect() {
    HeldConnections::Room room;
    EXPECT_FALSE(held_->whyNoPlace(kArm, room));
    auto channel = reference::armChannel(reference::playedEnds(), "rpc");
    kj::Own<ProviderEnd> end = kj::refcounted<PlayedEnd>(channel);
    held_->keep(kj::addRef(*end), channel, room);
    channels_.push_back(std::move(channel));
    return end;
  }
  /// Takes one more place, and returns why there is none.
  std::string take() {
    HeldConnections::Room room;
    const auto refusal = held_->whyNoPlace(kArm, room);
    if (!refusal) rooms_.push_back(std::move(room));
    return refusal ? refusal->text : "";
  }

  std::unique_ptr<HeldConnections> held_;
  std::vector<HeldConnections::Room> rooms_;
  std::vector<std::shared_ptr<Channel>> channels_;
};

TEST_F(HeldConnectionsTest, AnEndedOneGivesItsPlaceBack) {
  const std::vector<std::string> taken = there([this] {
    auto end = connect();
    while (rooms_.size() < HeldConnections::kMost - 1) take();
    std::vector<std::string> texts{take()};
    end->close();
    texts.push_back(take());
    texts.push_back(take());
    return texts;
  });
  EXPECT_TRUE(contains(taken[0], "this process has been given 1024 interfaces")) << taken[0];
  EXPECT_EQ(taken[1], "");
  EXPECT_NE(taken[2], "") << "two places came back for one";
}

TEST_F(HeldConnectionsTest, AFailedAttemptGivesItsPlaceBack) {
  const std::string why = there([this] {
    while (rooms_.size() < HeldConnections::kMost) take();
    rooms_.pop_back();
    return take();
  });
  EXPECT_EQ(why, "");
}

TEST_F(HeldConnectionsTest, TheSessionsEndEndsThemAll) {
  const std::string latest = there([this] {
    auto end = connect();
    connect();
    const LatestConnections::Latest one{
        .bootId = "boot", .epoch = 2, .incarnation = 1, .greeting = 1, .end = end.get()};
    shared_->latest.set("client", one);
    held_->end();
    LatestConnections::Latest earlier = one;
    earlier.epoch = 1;
    return shared_->latest.whySuperseded("client", "client -> provider", earlier);
  });
  ASSERT_EQ(channels_.size(), 2u);
  for (const auto& channel : channels_) EXPECT_EQ(channel->status, ChannelStatus::Closed);
  EXPECT_EQ(latest, "") << "what has ended still counts as the latest";
}

TEST_F(HeldConnectionsTest, MemoryBeyondTheLimitIsRefused) {
  const auto refusals = there([this] {
    HeldConnections::Room room;
    EXPECT_FALSE(held_->whyNoPlace(kArm, room));
    std::vector<std::optional<Refusal>> all;
    const std::size_t most = shared_->connectionMemory.peer;
    for (const std::size_t bytes : {most + 1, most}) {
      all.push_back(held_->whyNoMemory(kArm, room, bytes));
    }
    return all;
  });
  ASSERT_TRUE(refusals[0]);
  EXPECT_TRUE(contains(refusals[0]->text, "use 'robot:PSM/Arm': the connection would take"))
      << refusals[0]->text;
  EXPECT_FALSE(refusals[1]) << "what is refused is held all the same";
}

}  // namespace
}  // namespace suture
