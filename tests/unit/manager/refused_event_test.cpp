// A subscriber refuses an event of which a bit was flipped on the way; it must get what follows.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/periodic_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/names/manager_link.h>
#include <suture/net/dialer.h>
#include <suture/peer.capnp.h>

#include <atomic>

#include "reference/arm_like.capnp.h"
#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Publishes a row and emits an event in each of its cycles.
struct TalkingArm final : PeriodicTask, StillArm {
  TalkingArm() : PeriodicTask({.period = 1ms}) {}
  ~TalkingArm() override { stop(); }
  void run() override { port.emit().stopped(); }
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct Sent {
  std::atomic<int> events{0}, rows{0};
};

/// Refuses every second event and every second row.
class RefusingSubscriber final : public reference::wire::ArmLikeEvents::Server {
 public:
  explicit RefusingSubscriber(Sent& sent) : sent_(sent) {}

 protected:
  kj::Promise<void> stopped(StoppedContext) override { return judge(++sent_.events); }
  kj::Promise<void> state(StateContext) override { return judge(++sent_.rows); }

 private:
  static kj::Promise<void> judge(int count) {
    if (count % 2 == 0) return kj::READY_NOW;
    return loop::failure(kj::Exception::Type::FAILED, "no such pose");
  }

  Sent& sent_;
};

class RefusedEvents : public testing::Test {
 protected:
  RefusedEvents() {
    there_.add("PSM", arm_);
    there_.start();
    client_.run(kPatience, [this, names = net::Address::parse(names_.address())] {
      auto manager = kj::heap<ManagerLink>(client_, std::vector{names}, "test");
      auto& held = *manager;
      return held.open(kPatience)
          .then([&held] { return held.resolve("there", kPatience); })
          .then([this](ProcessRecord process) {
            return net::dial(client_.port(), net::Address::parse(process.addresses.at(0)), 5s);
          })
          .then([this](kj::AutoCloseFd socket) { return subscribe(kj::mv(socket)); })
          .attach(kj::mv(manager));
    });
  }
  ~RefusedEvents() noexcept override {
    client_.run(kPatience, [this] {
      contract_ = nullptr;
      link_ = nullptr;
    });
  }

  kj::Promise<void> subscribe(kj::AutoCloseFd socket) {
    link_ =
        kj::heap<framing::Link>(kj::heap<framing::MessageStream>(client_.port(), kj::mv(socket)),
                                capnp::rpc::twoparty::Side::CLIENT);
    auto peer = link_->bootstrap<wire::Peer>();
    auto hello = peer.helloRequest();
    hello.setVersion(wire::PROTOCOL_VERSION);
    hello.setProcess("left");
    auto open = peer.openRequest();
    open.setComponent("PSM");
    open.setInterface("Arm");
    return hello.send()
        .then([open = kj::mv(open)](auto&&) mutable { return open.send(); })
        .then([this](auto&& opened) {
          auto arm = opened.getContract().template castAs<reference::wire::ArmLike>();
          auto request = arm.subscribeRequest();
          request.setEvents(kj::heap<RefusingSubscriber>(sent_));
          request.setEventMask(~std::uint64_t{0});
          request.setStateMask(~std::uint64_t{0});
          contract_ = kj::mv(arm);  // without it there is no subscription
          return request.send().ignoreResult();
        });
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_, client_;
  GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  TalkingArm arm_;
  Manager there_{"there", names_.address()};
  Sent sent_;
  kj::Own<framing::Link> link_;
  kj::Maybe<reference::wire::ArmLike::Client> contract_;
};

TEST_F(RefusedEvents, AreLostAlone) {
  EXPECT_TRUE(eventually([this] { return sent_.events >= 100; }));
  EXPECT_TRUE(eventually([this] { return sent_.rows >= 100; }));
}

TEST_F(RefusedEvents, AreCountedAsDropped) {
  EXPECT_TRUE(eventually([this] { return sent_.events >= 100; }));
  EXPECT_GE(there_.channels().at(0)->events.dropped(), 49u);
}

}  // namespace
}  // namespace suture
