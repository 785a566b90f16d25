// These commands run in the caller's thread, where it shares a process with the provider.
#include "conformance/setup.h"
#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::kPatience;

class CallersThread : public Conformance {
 protected:
  void SetUp() override {
    Conformance::SetUp();
    if (!IsSkipped()) connect("Gripper", "Gripper");
  }
  void expectRanWhereItBelongs() const {
    const bool here = arm->at([](ArmComponent& one) { return one.ranIn(); }) == gettid();
    EXPECT_EQ(here, GetParam().isDirect());
  }
};
/// The provider is a task of this process, so that its other commands wait for its thread.
class CallersThreadAndATask : public CallersThread {};

TEST_P(CallersThread, ADirectCommandRunsThere) {
  client->withGripper([&](Gripper& remote) {
    ASSERT_TRUE(remote.release.start().within(kPatience));
    expectRanWhereItBelongs();
    ASSERT_TRUE(remote.release());
  });
  EXPECT_TRUE(eventuallyTaken({"release", "release"}));
}

TEST_P(CallersThread, AConcurrentReadIsAnsweredThere) {
  client->withGripper([&](Gripper& remote) {
    const auto narrow = remote.fits.start(0.05).within(kPatience);
    ASSERT_TRUE(narrow) << suture::toString(narrow.error());
    EXPECT_TRUE(*narrow);
    expectRanWhereItBelongs();
    EXPECT_FALSE(*remote.fits.start(0.2).within(kPatience));
  });
}

TEST_P(CallersThreadAndATask, CallersDoNotAwaitABusyProvider) {
  stall();
  client->withGripper([](Gripper& remote) {
    auto released = remote.release.start();
    auto fits = remote.fits.start(0.05);
    EXPECT_TRUE(released.poll());
    EXPECT_TRUE(fits.poll());
  });
  EXPECT_EQ(arm->taken(), std::vector<std::string>{"release"});
  arm->gate().open();
  EXPECT_TRUE(eventuallyTaken({"release", "disable"}));
}

TEST_P(CallersThread, AThrowFaultsTheProviderAlone) {
  client->withGripper([](Gripper& remote) {
    const auto thrown = remote.fits.start(-1).within(kPatience);
    ASSERT_FALSE(thrown);
    EXPECT_EQ(thrown.error(), Errc::Faulted);
  });
  EXPECT_TRUE(suture::eventually([&] { return arm->state() == suture::ComponentState::Faulted; }));
  EXPECT_EQ(arm->fault(), "no such width");
  EXPECT_EQ(client->component().state(), suture::ComponentState::Running);
  EXPECT_TRUE(suture::eventually([&] {
    Errc error{};
    client->withGripper([&](Gripper& remote) { error = remote.unusable(); });
    return error == Errc::Faulted;
  }));
}

INSTANTIATE_TEST_SUITE_P(Lanes, CallersThread, testing::ValuesIn(laneRows()), nameOf);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CallersThreadAndATask);  // over a lane that was added
INSTANTIATE_TEST_SUITE_P(Lanes, CallersThreadAndATask,
                         testing::ValuesIn(laneRows([](const Row& row) {
                           return row.isDirect() && !row.providerIsDevice();
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
