// A client and its provider are far from each other: what either says takes long to arrive.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <unistd.h>

#include "fault/forwarder.h"
#include "fault/operator.h"
#include "paths.h"
#include "support/child.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

constexpr Duration kEachWay = 300ms;  // no answer comes within the first limit of an attempt

class SlowLink : public testing::TestWithParam<Lane> {
 protected:
  std::unique_ptr<Child> provider(std::vector<std::string> command) const {
    for (const std::string& one : {std::string(paths::kFaultyHost), names_.address(),
                                   std::string("behind"), directory_.file("hang")}) {
      command.push_back(one);
    }
    auto child = std::make_unique<Child>(command);
    EXPECT_EQ(child->line(), "ready");
    return child;
  }

  /// Cuts the connection twice, and expects that it comes back.
  void cutAndAwait() {
    Forwarder forwarder(names_.address(), "there", "behind",
                        net::Address::parse("tcp://127.0.0.1:0"), 1);
    forwarder.proxy->delay(kEachWay);
    Operator client;
    Manager here("here", names_.address());
    here.add("Operator", client);
    here.start();
    here.connect("Operator/Arm", "there:PSM1/Arm",
                 {.lane = GetParam(), .contract = {.silence = 10s}});
    const auto answers = [&] { return client.error == Errc{}; };
    ASSERT_TRUE(eventually(answers));
    const std::string lane = here.channels().at(0)->lane;
    for (int round = 0; round < 2; ++round) {
      forwarder.proxy->strike(ByteProxy::Strike::Cut);
      ASSERT_TRUE(eventually([&] { return client.error == Errc::Lost; })) << round;
      ASSERT_TRUE(eventually(answers)) << round;
      EXPECT_EQ(here.channels().at(0)->lane, lane);
    }
  }

  const TemporaryDirectory directory_;
  loop::ControlThread control_;
  const GlobalManager names_{control_, "tcp://127.0.0.1:0"};
};

INSTANTIATE_TEST_SUITE_P(Lanes, SlowLink, testing::Values(Lane::Frame, Lane::Rpc),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(SlowLink, ALostConnectionComesBack) {
  const auto child = provider({});
  cutAndAwait();
}

// The clocks have to be compared, which takes more questions.
TEST_P(SlowLink, ALostConnectionOfAnotherClockReturns) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give a process another clock";
  const auto child =
      provider({"/usr/bin/unshare", "--time", "--monotonic", "1000", "--fork", "--kill-child"});
  cutAndAwait();
}

}  // namespace
}  // namespace suture
