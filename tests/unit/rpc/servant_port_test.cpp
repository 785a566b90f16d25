// What a client in another process is told of its calls when a provider ends.
#include <suture/loop/kj_comparisons.h>  // first

#include <gtest/gtest.h>
#include <suture/framing/remote_error.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/control_thread.h>

#include <memory>

#include "reference/arm_like.capnp.h"
#include "reference/played_channel.h"
#include "support/patience.h"

namespace suture::rpc {
namespace {

/// The provider's end of a connection, whose task is played by the test.
struct Provider {
  explicit Provider(ControlThread& control)
      : channel(reference::armChannel(
            {.client = control.sharedDoorbell(), .provider = bell, .watcher = bell}, "rpc")),
        port(kj::refcounted<ServantPort>(control, channel, std::make_shared<LinkCounters>())),
        arm(capnp::Capability::Client(kj::heap<Servant>(kj::addRef(*port)))
                .castAs<reference::wire::ArmLike>()) {}
  ~Provider() noexcept(false) { port->close(); }

  /// Calls reset(), which answers.
  kj::Promise<void> call() { return arm.resetRequest().send().ignoreResult(); }
  /// The number of the call that the provider is executing from now on.
  std::uint32_t begin() {
    channel->commands.fixCut();
    return channel->commands.next()->call;
  }

  const std::shared_ptr<rt::Doorbell> bell = std::make_shared<rt::Doorbell>();
  const std::shared_ptr<Channel> channel;
  kj::Own<ServantPort> port;
  reference::wire::ArmLike::Client arm;
};

/// How a call ends that is being executed when `end` happens to the provider.
template <class End>
Errc outcomeOf(const End& end) {
  ControlThread control;
  return control.run(kPatience, [&control, &end] {
    auto provider = kj::heap<Provider>(control);
    kj::Promise<void> call = provider->call();
    auto ended = kj::evalLast([&control, &end, &provider = *provider] {  // the call has arrived
      end(provider, provider.begin());
      control.doorbell().ring();
    });
    return ended.then([call = kj::mv(call)]() mutable { return kj::mv(call); })
        .then([] { return Errc{}; }, [](kj::Exception&& why) { return errcOf(why); })
        .attach(kj::mv(provider));
  });
}

TEST(ServantPort, ACallThatIsBeingExecutedAtTheEndIsOfUnknownOutcome) {
  for (const ChannelStatus status : {ChannelStatus::Lost, ChannelStatus::Lapsed}) {
    EXPECT_EQ(
        outcomeOf([status](Provider& provider, std::uint32_t) { provider.channel->tell(status); }),
        Errc::OutcomeUnknown);
  }
}

TEST(ServantPort, AnAnswerBeforeTheEndIsTold) {
  EXPECT_EQ(outcomeOf([](Provider& provider, std::uint32_t call) {
              provider.channel->replyError(call, Errc::Late);
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

}  // namespace
}  // namespace suture::rpc
