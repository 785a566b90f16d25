// A client learns when something is wrong at the other end.
#include <optional>

#include "conformance/setup.h"
#include "support/patience.h"
#include "support/test_thread.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class Failures : public Conformance {};
/// The provider has a life of its own: it can end while the client lives.
class Endings : public Conformance {};
/// The provider is a task: a device would have to end inside its own handler.
class EndingsOfTasks : public Conformance {};

TEST_P(Failures, AThrowingHandlerParksOnlyItsComponent) {
  arm->at([](ArmComponent& one) { one.throwOnEnable = true; });
  client->with([](Arm& remote) {
    const auto answer = remote.set_mode.start(Mode::Enabled).within(kPatience);
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

TEST_P(Failures, ASuspendedProviderSaysSo) {
  const auto answer = [&] {
    Errc error{};
    client->with([&](Arm& remote) {
      const auto held = remote.hold.start().within(kPatience);
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
    suture::TestThread stranger([&remote] {
      const auto answer = remote.hold();
      ASSERT_FALSE(answer);
      EXPECT_EQ(answer.error(), Errc::WrongThread);
    });
    stranger.join();
  });
}

TEST_P(Endings, AProviderThatEndsIsLost) {
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

TEST_P(EndingsOfTasks, AWaitingCallIsNotExecutedLater) {
  stall();
  using Distance = decltype(std::declval<Arm&>().distance.start(poseAt(1)));
  std::optional<Distance> behind;
  client->with([&](Arm& remote) { behind.emplace(remote.distance.start(poseAt(1))); });
  arm->gate().opensAt(suture::now() + 20ms);  // stopProvider() returns after the handler
  stopProvider();
  client->with([&](Arm&) {
    const auto& answer = behind->within(kPatience);
    ASSERT_FALSE(answer.has_value());
    // The client cannot know more of what the provider has not heard, or has no lane left to tell.
    EXPECT_TRUE(answer.error() == Errc::Lost || answer.error() == Errc::OutcomeUnknown);
    behind.reset();
  });
}

// It has no lane.
TEST(Unconnected, AnInterfaceSaysSo) {
  DeviceClient lonely;
  lonely.with([](Arm& remote) {
    EXPECT_EQ(remote.hold().error(), Errc::NotConnected);
    EXPECT_EQ(remote.measured_cp().error(), Errc::NotConnected);
    EXPECT_EQ(remote.distance.start(poseAt(1)).within(1s).error(), Errc::NotConnected);
    EXPECT_EQ(remote.on().stopped.next().within(1s).error(), Errc::NotConnected);
  });
}

INSTANTIATE_TEST_SUITE_P(Lanes, Failures, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, Endings, testing::ValuesIn(wireRows(&Row::providerCanEnd)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, EndingsOfTasks, testing::ValuesIn(wireRows([](const Row& row) {
                           return !row.providerIsDevice();
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
