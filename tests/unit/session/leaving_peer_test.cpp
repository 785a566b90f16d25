// A provider's process ends while it is being connected to: the client hears of it at once, not
// when its patience ends.

#include <gtest/gtest.h>
#include <suture/framing/link_server.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/peer.capnp.h>
#include <unistd.h>

#include "reference/remote_arm.h"
#include "support/contains.h"
#include "support/patience.h"
#include "support/refusal.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Says when the peer ends its links, instead of an answer.
enum class Leaves { AtHello, AtPing, AtSocket, AtConnect, Never };

/// Answers what a provider answers until it leaves, but has no components.
class LeavingPeer final : public wire::Peer::Server {
 public:
  LeavingPeer(Leaves when, std::function<void()> leave) : when_(when), leave_(std::move(leave)) {}

 protected:
  kj::Promise<void> hello(HelloContext context) override {
    if (when_ == Leaves::AtHello) return left();
    context.getResults().setAccepted();
    context.getResults().setBootId("another machine");
    context.getResults().setReceived(1);
    context.getResults().setSent(1);
    return kj::READY_NOW;
  }
  // Answers the pings by which the clocks are compared.
  kj::Promise<void> ping(PingContext context) override {
    if (context.getParams().hasComponents() && when_ == Leaves::AtPing) return left();
    context.getResults().initTasks(context.getParams().getComponents().size());
    return kj::READY_NOW;
  }
  kj::Promise<void> compared(ComparedContext) override { return kj::READY_NOW; }
  kj::Promise<void> socket(SocketContext context) override {
    if (when_ != Leaves::Never) return left();
    context.getResults().setToken(kj::StringPtr("short").asBytes());
    return kj::READY_NOW;
  }
  kj::Promise<void> connect(ConnectContext context) override {
    if (when_ == Leaves::AtConnect) return left();
    context.getResults().setDeclined("not here");
    return kj::READY_NOW;
  }

 private:
  kj::Promise<void> left() {
    leave_();
    return kj::NEVER_DONE;
  }

  const Leaves when_;
  const std::function<void()> leave_;
};

/// A LeavingProcess is a process with such a peer, as far as others see it.
class LeavingProcess {
 public:
  LeavingProcess(const std::string& manager, Leaves when) {
    control_.run(kPatience, [&] {
      server_ = std::make_unique<framing::LinkServer>(
          control_.port(), net::Address::parse(manager + ".leaving"),
          [this, when](auto) -> capnp::Capability::Client {
            return wire::Peer::Client(kj::heap<LeavingPeer>(
                when, [this] { control_.spawn(kj::evalLater([this] { server_.reset(); })); }));
          },
          refusals_);
      link_ = std::make_unique<ManagerLink>(control_, net::parseAddresses(manager), "robot");
      return link_->open(kPatience).then([this] {
        return link_->enrol({.name = "robot",
                             .addresses = {server_->address().text()},
                             .pid = getpid(),
                             .host = "here",
                             .components = {},
                             .generation = 0});
      });
    });
  }
  ~LeavingProcess() {
    control_.run(kPatience, [this] {
      link_.reset();
      server_.reset();
    });
  }
  LeavingProcess(const LeavingProcess&) = delete;
  LeavingProcess& operator=(const LeavingProcess&) = delete;

 private:
  net::Refusals refusals_{"robot"};
  loop::ControlThread control_;
  std::unique_ptr<framing::LinkServer> server_;
  std::unique_ptr<ManagerLink> link_;
};

class Leaving : public testing::TestWithParam<Leaves> {};
INSTANTIATE_TEST_SUITE_P(Moments, Leaving,
                         testing::Values(Leaves::AtHello, Leaves::AtPing, Leaves::AtSocket,
                                         Leaves::AtConnect));

TEST_P(Leaving, IsHeardOfAtOnce) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  const LeavingProcess robot(names.address(), GetParam());
  Teleop teleop;
  Manager console("console", names.address());
  console.add("Teleop", teleop);
  console.start();
  const std::string why = refusal([&] {
    console.connect("Teleop/Slave", "robot:PSM/Arm", {.patience = std::chrono::minutes(1)});
  });
  EXPECT_NE(why, "");
  EXPECT_FALSE(contains(why, "does not answer")) << why;
  if (GetParam() == Leaves::AtPing) {
    EXPECT_TRUE(contains(
        why, ": the link was closed: its process has ended, or the link is broken. Try again."))
        << why;
  }
}

TEST(Token, OfAnImpossibleSizeOpensNoLane) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  const LeavingProcess robot(names.address(), Leaves::Never);
  Teleop teleop;
  Manager console("console", names.address());
  console.add("Teleop", teleop);
  console.start();
  const std::string why = refusal([&] {
    console.connect("Teleop/Slave", "robot:PSM/Arm", {.lane = Lane::Rpc, .laneRequired = true});
  });
  EXPECT_TRUE(contains(why, "the token has an impossible size")) << why;
}

}  // namespace
}  // namespace suture
