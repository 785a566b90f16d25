// An event says when it was emitted, on the reader's clock, however long it took.
#include <suture/loop/kj_comparisons.h>  // first

#include <gtest/gtest.h>
#include <suture/framing/link.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/control_thread.h>

#include <chrono>
#include <memory>

#include "reference/arm_numbers.h"
#include "reference/played_channel.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/socket_pair.h"

namespace suture::rpc {
namespace {

using namespace std::chrono_literals;

using reference::kStopped;

/// Makes a channel of which one end belongs to the control thread, to a process whose clock stands
/// so to this one's.
std::shared_ptr<Channel> makeChannel(const std::shared_ptr<rt::Doorbell>& client,
                                     const std::shared_ptr<rt::Doorbell>& provider,
                                     Duration shift) {
  return reference::armChannel({.client = client,
                                .provider = provider,
                                .watcher = client,
                                .peer = reference::peerWithClock(shift)},
                               "rpc");
}

class CallStamps : public testing::Test {
 protected:
  CallStamps() {
    control_.run(kPatience, [this] {
      SocketPair pair = makeSocketPair();
      servant_ =
          kj::refcounted<ServantPort>(control_, far_, std::make_shared<framing::LinkCounters>());
      providersLink_ = linkOn(kj::mv(pair.theirs), Side::SERVER,
                              capnp::Capability::Client(kj::heap<Servant>(kj::addRef(*servant_))));
      clientsLink_ = linkOn(kj::mv(pair.ours), Side::CLIENT, nullptr);
      proxy_ = kj::refcounted<ProxyPort>(control_, near_, clientsLink_->counters());
      proxy_->open(clientsLink_->bootstrap<capnp::Capability>());
      return kj::Promise<void>(kj::READY_NOW);
    });
  }
  ~CallStamps() noexcept override {
    control_.run(kPatience, [this] {
      proxy_ = nullptr;
      servant_ = nullptr;
      clientsLink_ = nullptr;
      providersLink_ = nullptr;
      return kj::Promise<void>(kj::READY_NOW);
    });
  }

  /// Returns what the client hears of an event that was emitted at `emitted`.
  Time heard(Time emitted) {
    EXPECT_TRUE(far_->events.push(kStopped, emitted, {}));
    far_->ends.client->ring();
    const rt::EventRecord* record = nullptr;
    EXPECT_TRUE(eventually([&] { return (record = near_->events.next()) != nullptr; }));
    const Time stamp = record == nullptr ? Time{} : record->stamp;
    if (record != nullptr) near_->events.pop();
    return stamp;
  }

  loop::ControlThread control_;
  const std::shared_ptr<rt::Doorbell> bell_ = std::make_shared<rt::Doorbell>();
  const std::shared_ptr<Channel> near_ = makeChannel(bell_, control_.sharedDoorbell(), -7s);
  const std::shared_ptr<Channel> far_ = makeChannel(control_.sharedDoorbell(), bell_, 0s);
  kj::Own<ServantPort> servant_;
  kj::Own<ProxyPort> proxy_;
  kj::Own<framing::Link> providersLink_, clientsLink_;

 private:
  using Side = capnp::rpc::twoparty::Side;

  kj::Own<framing::Link> linkOn(kj::AutoCloseFd socket, Side side,
                                kj::Maybe<capnp::Capability::Client> offers) {
    return kj::heap<framing::Link>(
        kj::heap<framing::MessageStream>(control_.port(), kj::mv(socket)), side, kj::mv(offers));
  }
};

TEST_F(CallStamps, EventStampsAreOfTheClientsClock) {
  const Time emitted = now() + 1s;
  EXPECT_EQ(heard(emitted), emitted - 7s);
  EXPECT_EQ(heard(emitted + 1ms), emitted + 1ms - 7s);
}

TEST_F(CallStamps, NoEventComesFromTheFuture) {
  const Time stamp = heard(now() + 1h);
  EXPECT_LE(stamp, now());
}

}  // namespace
}  // namespace suture::rpc
