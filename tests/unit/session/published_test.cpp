// A request for an interface or a lane waits, while a process starts, until that has published.

#include <capnp/message.h>
#include <gtest/gtest.h>
#include <suture/loop/failure.h>
#include <suture/peer.capnp.h>
#include <suture/session/provider/lane_servers.h>
#include <suture/session/provider/served_peer.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "shared_scene.h"
#include "support/contains.h"

namespace suture {
namespace {

struct PlayedServer final : LaneServer {
  kj::Promise<AcceptedEnd> accept(IncomingConnection, capnp::AnyPointer::Reader,
                                  capnp::AnyPointer::Builder) override {
    return loop::failure(kj::Exception::Type::FAILED, "it is played");
  }
  void opened(LaneSocket) override {}
};

struct PlayedLane final : LaneKind {
  const char* name() const override { return "played"; }
  kj::Own<LaneClient> makeClient(ClientSession&) override { KJ_UNREACHABLE; }
  kj::Own<LaneServer> makeServer(ServerSession&) override { return kj::heap<PlayedServer>(); }
};

class PlayedSession final : public ServerSession {
 public:
  explicit PlayedSession(loop::ControlThread& thread) : thread_(thread) {}
  loop::ControlThread& control() override { return thread_; }
  void cutOff(const std::string&) override {}

 private:
  loop::ControlThread& thread_;
};

/// Plays the call that a peer has made.
class PlayedContext {
 public:
  wire::Peer::OpenResults::Builder getResults() {
    return message_->getRoot<wire::Peer::OpenResults>();
  }
  void allowCancellation() {}
  /// Returns what the peer is told instead of an answer; "" if nothing is.
  std::string refused() {
    return getResults().isRefused() ? codec::stringOf(getResults().getRefused().getText()) : "";
  }

 private:
  const std::shared_ptr<capnp::MallocMessageBuilder> message_ =
      std::make_shared<capnp::MallocMessageBuilder>();
};

class PublishedTest : public SharedScene {
 protected:
  void SetUp() override {
    SharedScene::SetUp();
    there([this] {
      peer_ = std::make_unique<ServedPeer>(*shared_, std::make_shared<framing::Caller>());
      servers_ = std::make_unique<LaneServers>(*shared_, session_);
    });
  }
  void TearDown() override {
    there([this] {
      servers_.reset();
      peer_.reset();
    });
    SharedScene::TearDown();
  }

  /// Asks for an interface that appears at the attempt of that number, and publishes.
  std::string serve(int appears, std::optional<Refusal> withheld = std::nullopt) {
    return there([this, appears, withheld = std::move(withheld)] {
      PlayedContext context;
      auto served = peer_->serve(context, withheld, [this, appears]() -> kj::Promise<void> {
        if (++attempts_ < appears) throw SetupError("there is no such interface yet");
        return kj::READY_NOW;
      });
      before_ = attempts_;
      shared_->published.reach();
      return served.then([context]() mutable { return context.refused(); });
    });
  }

  PlayedSession session_{control_};
  std::unique_ptr<ServedPeer> peer_;
  std::unique_ptr<LaneServers> servers_;
  int attempts_ = 0;
  int before_ = 0;  // attempts that came before the process had published
};

TEST_F(PublishedTest, AnInterfaceIsAwaited) {
  EXPECT_EQ(serve(2), "");
  EXPECT_EQ(before_, 1);
  EXPECT_EQ(attempts_, 2);
}

TEST_F(PublishedTest, AnInterfaceThatStaysAwayIsRefused) {
  EXPECT_TRUE(contains(serve(3), "there is no such interface yet"));
  EXPECT_EQ(attempts_, 2);
  EXPECT_TRUE(contains(shared_->refusals.summary().latest, "there is no such interface yet"));
}

TEST_F(PublishedTest, AWithheldInterfaceIsNotLookedFor) {
  EXPECT_EQ(serve(1, Refusal{wire::Refusal::Kind::NOT_PERMITTED, "it is withheld"}),
            "it is withheld");
  EXPECT_EQ(attempts_, 0);
  EXPECT_FALSE(peer_->caller().known) << "a stranger gains time by what it may not have";
}

TEST_F(PublishedTest, ALaneIsAwaited) {
  const bool found = there([this] {
    auto lane = servers_->named("played");
    lanes_.push_back(std::make_unique<PlayedLane>());
    shared_->published.reach();
    return lane.then([](LaneServer* server) { return server != nullptr; });
  });
  EXPECT_TRUE(found);
}

TEST_F(PublishedTest, AMissingLaneIsAnError) {
  const std::string why = there([this] {
    auto lane = servers_->named("played");
    shared_->published.reach();
    return lane.then([](LaneServer*) { return std::string(); },
                     [](kj::Exception&& error) { return loop::describe(error); });
  });
  EXPECT_TRUE(contains(why, "the provider's process has no lane 'played'")) << why;
}

}  // namespace
}  // namespace suture
