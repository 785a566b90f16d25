// These tests say by which lane a connection travels, and what is said if it cannot have the one
// that is asked for.

#include <gtest/gtest.h>
#include <suture/lane/frame/frame_lane.h>
#include <suture/lane/lane_kind.h>
#include <suture/loop/failure.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "reference/played_client.h"
#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/patience.h"
#include "support/refusal.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr const char* kTcp = "tcp://127.0.0.1:0";

/// Leaves it to the provider to say if the lane can carry a connection.
class HopefulLane final : public LaneKind {
 public:
  const char* name() const override { return "hope"; }
  kj::Own<LaneClient> makeClient(ClientSession&) override { return kj::heap<Client>(); }
  kj::Own<LaneServer> makeServer(ServerSession&) override { return kj::heap<Server>(); }

 private:
  struct Attempt final : LaneAttempt {
    void request(capnp::AnyPointer::Builder) override {}
    kj::Promise<OpenedEnd> open(OutgoingConnection, capnp::AnyPointer::Reader) override {
      return loop::failure(kj::Exception::Type::FAILED, "nobody accepts");
    }
  };
  struct Client final : LaneClient {
    std::string whyNot(const OutgoingConnection&) const override { return ""; }
    kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection&) override {
      return kj::Own<LaneAttempt>(kj::heap<Attempt>());
    }
  };
  struct Server final : LaneServer {
    kj::Promise<AcceptedEnd> accept(IncomingConnection, capnp::AnyPointer::Reader,
                                    capnp::AnyPointer::Builder) override {
      return loop::failure(kj::Exception::Type::FAILED, "there is no hope");
    }
    void opened(LaneSocket) override {}
  };
};

/// Could carry a connection if it did not fail.
class FailingLane final : public LaneKind {
 public:
  /// `attempts` counts how often it was tried.
  FailingLane(const char* name, std::atomic<unsigned>& attempts)
      : name_(name), attempts_(attempts) {}
  const char* name() const override { return name_; }
  kj::Own<LaneClient> makeClient(ClientSession&) override { return kj::heap<Client>(*this); }
  kj::Own<LaneServer> makeServer(ServerSession&) override { return {}; }

 private:
  struct Client final : LaneClient {
    explicit Client(FailingLane& lane) : lane_(lane) {}
    std::string whyNot(const OutgoingConnection&) const override { return ""; }
    kj::Promise<kj::Own<LaneAttempt>> attempt(const OutgoingConnection&) override {
      ++lane_.attempts_;
      return loop::failure(kj::Exception::Type::FAILED, std::string(lane_.name_) + " is broken");
    }
    FailingLane& lane_;
  };
  const char* const name_;
  std::atomic<unsigned>& attempts_;
};

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class LaneChoice : public RemoteArm {
 protected:
  /// Returns what is said if the connection cannot be made so; "" if it can.
  std::string refusalOf(const ConnectOptions& options) {
    return refusal([&] { console->connect("Teleop/Slave", "robot:PSM/Arm", options); });
  }
};

TEST_F(LaneChoice, TheNextSlowerLaneIsTaken) {
  begin(kTcp);
  EXPECT_EQ(refusalOf({.lane = Lane::Shm}), "");
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->terms.laneReason, "the two processes are not reached by a Unix socket");
}

TEST_F(LaneChoice, ADelayedConnectionExplainsItsLane) {
  begin(kTcp);
  EXPECT_EQ(refusalOf({.lane = Lane::Shm, .delay = {.commands = 1ms}}), "");
  EXPECT_EQ(channel()->lane, "frame+delay");
  EXPECT_EQ(channel()->terms.laneReason, "the two processes are not reached by a Unix socket");
}

TEST_F(LaneChoice, AnImpossibleRequiredLaneIsAnError) {
  begin(kTcp);
  EXPECT_TRUE(contains(refusalOf({.lane = Lane::Shm, .laneRequired = true}),
                       "connecting console:Teleop/Slave -> robot:PSM/Arm: lane 'shm' is required "
                       "and cannot carry it: the two processes are not reached by a Unix socket."));
  EXPECT_EQ(refusalOf({.lane = Lane::Rpc, .laneRequired = true}), "");
  EXPECT_EQ(channel()->lane, "rpc");
}

TEST_F(LaneChoice, ARequiredLaneHasAName) {
  begin(kTcp);
  EXPECT_TRUE(contains(refusalOf({.laneRequired = true}), "it requires a lane and names none"));
}

TEST_F(LaneChoice, AnUnknownLaneIsAnError) {
  begin(kTcp);
  EXPECT_TRUE(contains(refusalOf({.lane = {"hope"}}),
                       "connecting console:Teleop/Slave -> robot:PSM/Arm: this process has no lane "
                       "'hope'; it has 'shm', 'frame' and 'rpc'."));
  console->addLane(std::make_unique<HopefulLane>());
  EXPECT_TRUE(contains(refusalOf({.lane = {"hop"}}), "it has 'shm', 'frame', 'rpc' and 'hope'."));
}

// A wrong name is none that a wait could mend.
TEST_F(LaneChoice, AnUnknownLaneIsToldFirst) {
  begin(kTcp);
  const auto refused = refusal([&] {
    console->connect("Teleop/Slave", "nobody:PSM/Arm", {.lane = {"hope"}, .patience = 1ms});
  });
  EXPECT_TRUE(contains(refused, "this process has no lane 'hope'")) << refused;
}

TEST_F(LaneChoice, ALaneOfOneProcessIsDeclined) {
  begin(kTcp);
  console->addLane(std::make_unique<HopefulLane>());
  EXPECT_TRUE(contains(refusalOf({.lane = {"hope"}}),
                       "no lane can carry it. The last says: the provider's process has no lane "
                       "'hope'."));
}

/// A SocketSeeker is a client, played by the test, that asks a process for a socket of a lane.
class SocketSeeker : public reference::PlayedClient {
 public:
  using PlayedClient::PlayedClient;
  ~SocketSeeker() {
    control_.run(kPatience, [this] { answer_ = kj::READY_NOW; });
  }

  /// Asks, and returns when the process has heard it: it takes what a link brings in its order.
  void ask(const std::string& lane) {
    control_.run(kPatience, [&] {
      auto request = peer().socketRequest();
      request.setLane(lane);
      answer_ = request.send()
                    .then([this](auto&&) { said_ = "given"; },
                          [this](kj::Exception&& why) { said_ = loop::describe(why); })
                    .eagerlyEvaluate(nullptr);
      return peer().pingRequest().send().ignoreResult();
    });
  }
  /// Returns what the process has answered so far.
  std::string said() {
    return control_.run(kPatience, [this] { return kj::Promise<std::string>(said_); });
  }

 private:
  std::string said_;
  kj::Promise<void> answer_ = kj::READY_NOW;
};

// Its name is known as soon as the process is, and a lane comes when its program gets to it.
TEST_F(LaneChoice, ALaneToBeAddedIsAwaited) {
  begin(kTcp);
  Manager starting("starting", manager());
  SocketSeeker seeker(manager(), "starting");
  seeker.greet();
  seeker.ask("late");
  EXPECT_EQ(seeker.said(), "");
  starting.addLane(std::make_unique<frame::FrameLane>("late"));
  starting.start();
  EXPECT_TRUE(eventually([&] { return seeker.said() == "given"; })) << seeker.said();
}

TEST_F(LaneChoice, AnAbsentLaneIsRefusedLater) {
  begin(kTcp);
  Manager starting("starting", manager());
  SocketSeeker seeker(manager(), "starting");
  seeker.greet();
  seeker.ask("late");
  starting.start();
  EXPECT_TRUE(eventually([&] {
    return contains(seeker.said(), "the provider's process has no lane 'late'");
  })) << seeker.said();
}

TEST_F(LaneChoice, AnAddedLaneMustBeAskedFor) {
  begin(kTcp);
  console->addLane(std::make_unique<HopefulLane>());
  EXPECT_EQ(refusalOf({}), "");
  EXPECT_EQ(channel()->lane, "frame");
}

// A session has its lanes from when it begins, so a later connection could not find the new one.
TEST_F(LaneChoice, NoLaneJoinsStandingConnections) {
  begin(kTcp);
  connect(Lane::Frame);
  const std::string refused = refusal([&] { console->addLane(std::make_unique<HopefulLane>()); });
  EXPECT_EQ(refused,
            "adding lane 'hope': this process has connections, whose sessions do not know it. Add "
            "it before the first connection");
  EXPECT_TRUE(contains(refusalOf({.lane = {"hope"}}), "it is already connected"));
  console->disconnect("Teleop/Slave");
  console->addLane(std::make_unique<HopefulLane>());
  EXPECT_TRUE(contains(refusalOf({.lane = {"hope"}}), "has no lane 'hope'"));
}

// The next connection would join the session that is being made, which has the earlier lanes.
TEST_F(LaneChoice, NoLaneJoinsADialUnderWay) {
  begin(kTcp);
  console->giveUp();
  EXPECT_TRUE(contains(
      refusal([&] { console->connect("Teleop/Slave", "nobody:PSM/Arm", {.patience = 60s}); }),
      "told to end while it waited"));
  EXPECT_TRUE(
      contains(refusal([&] { console->addLane(std::make_unique<HopefulLane>()); }),
               "adding lane 'hope': this process has connections, whose sessions do not know it"));
}

// The provider is started again without the lane, so the client tries all of them again and again.
TEST_F(LaneChoice, EachFailingLaneIsToldOnce) {
  std::atomic<unsigned> one{0}, two{0};
  begin(kTcp);
  console->addLane(std::make_unique<FailingLane>("one", one));
  console->addLane(std::make_unique<FailingLane>("two", two));
  for (Manager* const process : {console.get(), robot.get()}) {
    process->addLane(std::make_unique<frame::FrameLane>("last"));
  }
  testing::internal::CaptureStderr();
  connect({"one"});
  restartRobot();
  EXPECT_TRUE(eventually([&] { return !console->whyNotBack().empty(); }));
  const unsigned before = std::max(one.load(), two.load());
  EXPECT_TRUE(eventually([&] { return std::min(one.load(), two.load()) > before + 1; }));
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(occurrences(told, "by lane 'one': one is broken"), 1u) << told;
  EXPECT_EQ(occurrences(told, "by lane 'two': two is broken"), 1u) << told;
}

// A client that asked for it would get another.
TEST_F(LaneChoice, NoLaneIsCalledAuto) {
  begin(kTcp);
  EXPECT_TRUE(
      contains(refusal([&] { console->addLane(std::make_unique<frame::FrameLane>("auto")); }),
               "there is one of that name"));
}

TEST_F(LaneChoice, ALaneIsAddedOnce) {
  begin(kTcp);
  console->addLane(std::make_unique<HopefulLane>());
  EXPECT_TRUE(contains(refusal([&] { console->addLane(std::make_unique<HopefulLane>()); }),
                       "there is one of that name"));
  Manager alone("alone");
  EXPECT_TRUE(contains(refusal([&] { alone.addLane(std::make_unique<HopefulLane>()); }),
                       "has no global manager"));
}

}  // namespace
}  // namespace suture
