// What a client learns when something is wrong at the other end.
#include "conformance/setup.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;

class Failures : public Conformance {};

TEST_P(Failures, AHandlerThatThrowsParksItsComponentOnly) {
  arm->at([](ArmComponent& one) { one.throwOnEnable = true; });
  client->with([](Arm& remote) {
    const auto answer = remote.set_mode.start(Mode::Enabled).within(5s);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), Errc::Faulted);
  });
  EXPECT_TRUE(suture::eventually([&] { return arm->state() == suture::ComponentState::Faulted; }));
  EXPECT_EQ(arm->fault(), "the drive did not answer");
  EXPECT_TRUE(suture::eventually([&] {
    Errc error{};
    client->with([&](Arm& remote) {
      const auto held = remote.hold();
      error = held ? Errc{} : held.error();
    });
    return error == Errc::Faulted;
  }));
  EXPECT_NE(client->component().state(), suture::ComponentState::Faulted);
}

TEST_P(Failures, ASuspendedProviderSaysSoUntilItIsResumed) {
  const auto answer = [&] {
    Errc error{};
    client->with([&](Arm& remote) {
      const auto held = remote.hold.start().within(5s);
      error = held ? Errc{} : held.error();
    });
    return error;
  };
  EXPECT_EQ(answer(), Errc{});
  const std::vector<std::string> taken = arm->taken();
  arm->at([](ArmComponent& one) { one.component().request(suture::Transition::Suspend); });
  EXPECT_TRUE(
      suture::eventually([&] { return arm->state() == suture::ComponentState::Suspended; }));
  EXPECT_EQ(answer(), Errc::Suspended) << "whether or not the client has been told";
  EXPECT_TRUE(suture::eventually([&] {
    Errc error{};
    client->with([&](Arm& remote) { error = remote.unusable(); });
    return error == Errc::Suspended;
  }));
  client->with([](Arm& remote) {
    EXPECT_EQ(remote.hold().error(), Errc::Suspended);
    EXPECT_EQ(remote.measured_cp().error(), Errc::Suspended);
  });

  arm->at([](ArmComponent& one) { one.component().request(suture::Transition::Resume); });
  EXPECT_TRUE(suture::eventually([&] { return answer() == Errc{}; }));
  EXPECT_EQ(arm->taken().front(), taken.front());
  EXPECT_EQ(arm->taken().size(), taken.size() + 1) << "what was refused was executed later";
}

TEST_P(Failures, AnotherThreadIsTurnedAway) {
  client->with([](Arm& remote) {
    EXPECT_TRUE(remote.hold());
    std::thread stranger([&remote] {
      const auto answer = remote.hold();
      ASSERT_FALSE(answer);
      EXPECT_EQ(answer.error(), Errc::WrongThread);
    });
    stranger.join();
  });
}

TEST_P(Failures, AProviderThatEndsIsLost) {
  if (shareManager() && providerIsDevice()) return;  // it has no life of its own
  stopProvider();
  EXPECT_TRUE(suture::eventually([&] {
    Errc error{};
    client->with([&](Arm& remote) {
      const auto held = remote.hold();
      error = held ? Errc{} : held.error();
    });
    return error == Errc::Lost;
  }));
}

TEST_P(Failures, ACallUnderWayWhenTheProviderEndsIsOfUnknownOutcome) {
  if (providerIsDevice()) return;  // it would have to end inside its own handler
  arm->gate().close();
  client->with([&](Arm& remote) {
    auto call = remote.set_mode.start(Mode::Disabled);
    remote.owner().ringNow();
    arm->gate().awaitVisitor();
    auto behind = remote.distance.start(poseAt(1));
    remote.owner().ringNow();
    std::thread opener([&] {
      std::this_thread::sleep_for(20ms);
      arm->gate().open();
    });
    stopProvider();
    EXPECT_TRUE(behind.within(5s).has_value() || behind.within(0s).error() == Errc::OutcomeUnknown);
    opener.join();
  });
}

TEST_P(Failures, AnUnconnectedInterfaceSaysSo) {
  DeviceClient lonely;
  lonely.with([](Arm& remote) {
    EXPECT_EQ(remote.hold().error(), Errc::NotConnected);
    EXPECT_EQ(remote.measured_cp().error(), Errc::NotConnected);
    EXPECT_EQ(remote.distance.start(poseAt(1)).within(1s).error(), Errc::NotConnected);
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, Failures, testing::ValuesIn(allCombinations()), nameOf);

}  // namespace
}  // namespace conformance
