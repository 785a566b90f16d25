// A client in another process is told of its calls when a provider ends.
#include <suture/loop/kj_comparisons.h>  // first

#include <gtest/gtest.h>
#include <kj/debug.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/control_thread.h>

#include <memory>

#include "reference/arm_like.capnp.h"
#include "reference/arm_numbers.h"
#include "reference/played_channel.h"
#include "support/patience.h"

namespace suture::rpc {
namespace {

/// This is the provider's end of a connection, whose task the test plays.
struct Provider {
  explicit Provider(loop::ControlThread& control)
      : channel(reference::armChannel(
            {.client = control.sharedDoorbell(), .provider = bell, .watcher = bell}, "rpc")),
        port(kj::refcounted<ServantPort>(control, channel,
                                         std::make_shared<framing::LinkCounters>())),
        arm(capnp::Capability::Client(kj::heap<Servant>(kj::addRef(*port)))
                .castAs<reference::wire::ArmLike>()) {}
  ~Provider() noexcept(false) { port->close(); }

  /// Calls reset(), which answers.
  kj::Promise<void> call() { return arm.resetRequest().send().ignoreResult(); }
  /// Returns the number of the call that the provider is executing from now on.
  std::uint32_t begin() {
    channel->commands.fixCut();
    return channel->commands.next()->call;
  }

  const std::shared_ptr<rt::Doorbell> bell = std::make_shared<rt::Doorbell>();
  const std::shared_ptr<Channel> channel;
  kj::Own<ServantPort> port;
  reference::wire::ArmLike::Client arm;
};

/// Returns how a call ends that is being executed when `end` happens to the provider.
template <class End>
Errc outcomeOf(const End& end) {
  loop::ControlThread control;
  return control.run(kPatience, [&control, &end] {
    auto provider = kj::heap<Provider>(control);
    kj::Promise<void> call = provider->call();
    auto ended = kj::evalLast([&control, &end, &provider = *provider] {  // the call has arrived
      end(provider, provider.begin());
      control.doorbell().ring();
    });
    return ended.then([call = kj::mv(call)]() mutable { return kj::mv(call); })
        .then([] { return Errc{}; }, [](kj::Exception&& why) { return framing::errcOf(why); })
        .attach(kj::mv(provider));
  });
}

TEST(ServantPort, ARunningCallHasAnUnknownOutcome) {
  for (const ChannelStatus status : {ChannelStatus::Lost, ChannelStatus::Lapsed}) {
    EXPECT_EQ(
        outcomeOf([status](Provider& provider, std::uint32_t) { provider.channel->tell(status); }),
        Errc::OutcomeUnknown);
  }
}

TEST(ServantPort, AnAnswerBeforeTheEndIsTold) {
  EXPECT_EQ(outcomeOf([](Provider& provider, std::uint32_t call) {
              provider.channel->provider.replyError(call, Errc::Late);
              provider.port->end();
            }),
            Errc::Late);
}

TEST(ServantPort, ALaterConnectionLeavesTheOutcomeUnknown) {
  EXPECT_EQ(outcomeOf([](Provider& provider, std::uint32_t) { provider.port->end(); }),
            Errc::OutcomeUnknown);
}

TEST(ServantPort, AFaultIsTold) {
  EXPECT_EQ(outcomeOf([](Provider& provider, std::uint32_t) {
              provider.channel->tell(ChannelStatus::Faulted);
            }),
            Errc::Faulted);
}

// Each ring wakes a sleeping task, which would take the calls of a burst one by one.
TEST(ServantPort, RingsOnceForABurst) {
  loop::ControlThread control;
  control.run(kPatience, [&control] {
    auto provider = kj::heap<Provider>(control);
    provider->bell->takeRing();
    kj::Promise<void> first = provider->call(), second = provider->call();
    auto arrived = kj::evalLast([&control, &provider = *provider] {
      EXPECT_EQ(provider.channel->commands.waiting(reference::kReset), 2u);
      EXPECT_EQ(provider.bell->takeRing(), rt::RungFor::Work) << "for the first";
      return control.timer().afterDelay(0 * kj::NANOSECONDS);
    });
    return arrived
        .then([&provider = *provider] {
          EXPECT_EQ(provider.bell->takeRing(), rt::RungFor::Work) << "for the second";
        })
        .attach(kj::mv(first), kj::mv(second), kj::mv(provider));
  });
}

using reference::kHold;
using reference::kSetMode;
using reference::kStopped;
using reference::kStoppedOnly;
using ArmEvents = reference::wire::ArmLikeEvents;

/// Hears of events and rows, or is in a process that has gone.
class Hearer final : public ArmEvents::Server {
 public:
  explicit Hearer(int* heard) : heard_(heard) {}

 protected:
  kj::Promise<void> stopped(StoppedContext) override { return hear(); }
  kj::Promise<void> state(StateContext) override { return hear(); }

 private:
  kj::Promise<void> hear() {
    if (heard_ == nullptr) return KJ_EXCEPTION(DISCONNECTED, "its process has gone");
    ++*heard_;
    return kj::READY_NOW;
  }

  int* const heard_;  // nullptr: gone
};

/// Resolves when nothing else is left to do.
kj::Promise<void> restOf(loop::ControlThread& control) {
  return control.timer().afterDelay(0 * kj::NANOSECONDS);
}

/// Pushes an event and a row for a subscriber that comes now, and lives as long as the hearer.
kj::Promise<void> emitTo(loop::ControlThread& control, Provider& provider, int* heard) {
  provider.channel->events.push(kStopped, now(), {});
  rt::RowColumns columns;
  columns.valid = 1;
  provider.channel->state->publish(now(), columns);
  provider.port->subscribe(
      Subscriber(ArmEvents::Client(kj::heap<Hearer>(heard)), provider.port->info()),
      {.events = kStoppedOnly, .joining = 0, .columns = 1});
  return restOf(control);
}

TEST(ServantPort, GoneSubscribersTakeNoPlaces) {
  loop::ControlThread control;
  int heard = 0;
  control.run(kPatience, [&] {
    auto provider = kj::heap<Provider>(control);
    kj::Promise<void> emitted = kj::READY_NOW;
    for (unsigned i = 0; i < ServantPort::kWindow; ++i) {
      emitted =
          emitted.then([&, &provider = *provider] { return emitTo(control, provider, nullptr); });
    }
    return emitted.then([&, &provider = *provider] { return emitTo(control, provider, &heard); })
        .attach(kj::mv(provider));
  });
  EXPECT_EQ(heard, 2);
}

/// Answers when the test says so.
class SlowHearer final : public ArmEvents::Server {
 public:
  explicit SlowHearer(kj::Own<kj::PromiseFulfiller<void>>& answer) : answer_(answer) {}

 protected:
  kj::Promise<void> stopped(StoppedContext) override {
    auto pair = kj::newPromiseAndFulfiller<void>();
    answer_ = kj::mv(pair.fulfiller);
    return kj::mv(pair.promise);
  }

 private:
  kj::Own<kj::PromiseFulfiller<void>>& answer_;
};

TEST(ServantPort, ALateSubscriberEndsNoLaterSubscription) {
  loop::ControlThread control;
  kj::Own<kj::PromiseFulfiller<void>> answer;
  int heard = 0;
  control.run(kPatience, [&] {
    auto provider = kj::heap<Provider>(control);
    Provider& it = *provider;
    it.channel->events.push(kStopped, now(), {});
    it.port->subscribe(Subscriber(ArmEvents::Client(kj::heap<SlowHearer>(answer)), it.port->info()),
                       {.events = kStoppedOnly, .joining = 0, .columns = 0});
    return restOf(control)
        .then([&] { return emitTo(control, it, &heard); })
        .then([&] {
          answer->reject(KJ_EXCEPTION(DISCONNECTED, "its process has gone"));
          return restOf(control);
        })
        .then([&] {
          it.channel->events.push(kStopped, now(), {});
          control.doorbell().ring();
          return restOf(control);
        })
        .then([&] { return restOf(control); })
        .attach(kj::mv(provider));
  });
  EXPECT_EQ(heard, 3) << "an event and a row, and the event after the other had gone";
}

// A command that a fault has rejected still waits in the mailbox.
TEST(ServantPort, AFaultGivesNoLaterCredit) {
  loop::ControlThread control;
  bool second = false, early = false;
  control.run(kPatience, [&] {
    auto provider = kj::heap<Provider>(control);
    Provider& it = *provider;
    const auto take = [&](std::uint16_t command) {
      it.channel->commands.fixCut();
      ASSERT_NE(it.channel->commands.next(), nullptr);
      it.channel->commands.pop();
      it.channel->commands.returnCredit(command);
      control.doorbell().ring();
    };
    auto first = it.arm.holdRequest().send().ignoreResult().catch_([](kj::Exception&&) {});
    return restOf(control)
        .then([&, first = kj::mv(first)]() mutable {
          it.channel->tell(ChannelStatus::Faulted);
          control.doorbell().ring();
          return kj::mv(first);
        })
        .then([&, take] {
          it.channel->tell(ChannelStatus::Connected);
          auto mode = it.arm.setModeRequest().send().ignoreResult();
          auto hold = it.arm.holdRequest()
                          .send()
                          .then([&](auto&&) { second = true; })
                          .eagerlyEvaluate(nullptr);
          auto taken = restOf(control).then([take, mode = kj::mv(mode)]() mutable {
            take(kHold);
            take(kSetMode);
            return kj::mv(mode);
          });
          return taken.then([&, take, hold = kj::mv(hold)]() mutable {
            early = second;
            take(kHold);
            return kj::mv(hold);
          });
        })
        .attach(kj::mv(provider));
  });
  EXPECT_FALSE(early);
  EXPECT_TRUE(second);
}

/// Tells when the last holder has let it go.
template <class Interface>
class Kept final : public Interface::Server {
 public:
  explicit Kept(bool& kept) : kept_(kept) { kept_ = true; }
  ~Kept() noexcept(false) { kept_ = false; }

 private:
  bool& kept_;
};

// The client's capabilities hold its end, and that holds the provider's.
TEST(ServantPort, KeepsNothingOfALateClient) {
  loop::ControlThread control;
  bool counts = false, events = false;
  control.run(kPatience, [&] {
    auto provider = kj::heap<Provider>(control);
    provider->port->close();
    provider->port->tellCounts(kj::heap<Kept<wire::CommandCounts>>(counts));
    provider->port->subscribe(
        Subscriber(ArmEvents::Client(kj::heap<Kept<ArmEvents>>(events)), provider->port->info()),
        {.events = kStoppedOnly, .joining = 0, .columns = 1});
    EXPECT_FALSE(counts);
    EXPECT_FALSE(events);
    return restOf(control).attach(kj::mv(provider));
  });
}

}  // namespace
}  // namespace suture::rpc
