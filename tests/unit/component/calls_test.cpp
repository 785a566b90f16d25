// Connections end while their calls wait for an answer, a client floods its provider with calls,
// and handlers of calls hear how these ended.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/wiring/connect.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "unit/component/arm_client.h"
#include "unit/component/driven_arm.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::Mode;

/// Runs a cycle only when the test calls cycle().
struct Provider final : Task {
  struct Arm final : CountingArm {
    void hold() override { onHold(); }
    void limit(double, Mode) override { ++limits; }
    std::function<void()> onHold = [] {};
    int limits = 0;
  };

  Provider() { start(); }
  ~Provider() override { stop(); }
  void start() override { enter(); }
  void stop() override { leave(); }
  using Task::cycle;

  Arm arm;
  Provided<ArmLike> port{*this, "Arm", arm};

 private:
  void run() override {}
};

TEST(Calls, AnAnswerThatCameOutlivesItsConnection) {
  Provider provider, successor;
  ArmClient client;
  connectLocally(client.arm, provider.port, "old");
  auto first = client.arm.hold.start(), second = client.arm.hold.start();
  auto third = client.arm.hold.start();
  provider.cycle();
  EXPECT_TRUE(first.poll());
  auto late = client.arm.hold.start();
  connectLocally(client.arm, successor.port, "new");
  EXPECT_TRUE(client.arm.connected());
  for (auto* answered : {&second, &third}) {
    ASSERT_TRUE(answered->poll());
    EXPECT_TRUE(*answered->poll());
  }
  ASSERT_TRUE(late.poll());
  EXPECT_EQ(late.poll()->error(), Errc::OutcomeUnknown);
}

TEST(Calls, AnUnreadAnswerOutlivesItsConnection) {
  Provider provider, successor;
  ArmClient client;
  connectLocally(client.arm, provider.port, "old");
  auto call = client.arm.hold.start();
  provider.cycle();
  connectLocally(client.arm, successor.port, "new");
  EXPECT_TRUE(client.arm.connected());
  ASSERT_TRUE(call.poll());
  EXPECT_TRUE(*call.poll());
}

TEST(Fairness, AFloodingClientDelaysByItsQueue) {
  for (const bool flooderFirst : {true, false}) {
    Provider provider;
    ArmClient flooder, other;
    connectLocally((flooderFirst ? flooder : other).arm, provider.port, "one");
    connectLocally((flooderFirst ? other : flooder).arm, provider.port, "two");
    int held = 0;
    provider.arm.onHold = [&] {
      ++held;
      if (held < 1000) (void)flooder.arm.hold();  // at once, in the drain that runs this
    };
    constexpr int kDepth = 4;  // hold() has a queue of so many
    for (int i = 0; i < kDepth; ++i) ASSERT_TRUE(flooder.arm.hold());
    for (int cycle = 1; cycle <= 10; ++cycle) {
      ASSERT_TRUE(other.arm.limit(1, Mode::Enabled));
      const int before = held;
      provider.cycle();
      EXPECT_EQ(provider.arm.limits, cycle);
      EXPECT_LE(held - before, kDepth);
      EXPECT_GT(held, before);
    }
  }
}

template <class Call>
concept PollsATemporary = requires(Call&& call) {
  std::move(call).poll();
};

TEST(Call, GivesAnUnkeptAnswerAway) {
  ArmClient client;
  const auto& answer = client.arm.hold.start().within(1ms);
  EXPECT_EQ(answer.error(), Errc::NotConnected);
  using Hold = decltype(client.arm.hold.start());
  static_assert(!std::is_reference_v<decltype(std::declval<Hold>().within())>);
  static_assert(!PollsATemporary<Hold>, "the answer would be gone before it is looked at");
}

TEST(Call, ItsHandlerHearsThatTheProviderEnds) {
  ArmClient client;
  Errc end{};
  {
    Provider provider;
    connectLocally(client.arm, provider.port, "test");
    client.arm.hold.start().then([&end](const Result<void>& answer) { end = answer.error(); });
    client.processEvents();
    EXPECT_EQ(end, Errc{});
  }
  client.processEvents();
  EXPECT_EQ(end, Errc::Lost);
}

TEST(Call, AStoppingProviderAnswersACall) {
  struct Stopping final : Task {
    void start() override {
      prepare();
      enter();
    }
    void stop() override { leave(); }
    void onStop() override { stopping(); }
    void run() override {}
    std::function<void()> stopping = [] {};
    CountingArm arm;
    Provided<ArmLike> port{*this, "Arm", arm};
  } provider;
  ArmClient client;
  const auto channel = connectLocally(client.arm, provider.port, "test");
  provider.start();
  std::optional<decltype(client.arm.hold.start())> call;
  provider.stopping = [&] {
    call.emplace(client.arm.hold.start());
    EXPECT_TRUE(client.arm.hold());
  };
  provider.stop();
  ASSERT_TRUE(call && call->poll());
  EXPECT_EQ(call->poll()->error(), Errc::Lost);
  EXPECT_EQ(channel->commands.counters.refused, 2u);
}

TEST(Call, ItsHandlerHearsOfARefusal) {
  ArmClient client;
  Errc end{};
  client.arm.hold.start().then([&end](const Result<void>& answer) { end = answer.error(); });
  EXPECT_EQ(end, Errc::NotConnected);
}

TEST(Call, ACancelledCallIsCounted) {
  Provider provider;
  ArmClient client;
  const auto channel = connectLocally(client.arm, provider.port, "test");
  int held = 0;
  provider.arm.onHold = [&] { ++held; };
  auto first = client.arm.hold.start();
  auto second = client.arm.hold.start();
  EXPECT_TRUE(first.cancel());
  provider.cycle();
  EXPECT_EQ(held, 1);
  EXPECT_FALSE(second.cancel());
  EXPECT_TRUE(*second.poll());
  EXPECT_EQ(channel->commands.counters.cancelled, 1u);
}

}  // namespace
}  // namespace suture
