// A provider that is killed takes its counts with it. What it may have executed is bounded by what
// could be on its way, on each lane.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/lane/frame/window.h>
#include <suture/lane/rpc/proxy_port.h>
#include <suture/manager/manager.h>
#include <suture/observe/observe.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

#include "fault/system.h"
#include "reference/arm_like.suture.h"
#include "support/eventually.h"
#include "support/patience.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

/// Sends until nothing more is taken.
struct Sender final : Device {
  /// Sends each command without latest() until it is refused, and one with it very often.
  void sendAll() {
    for (int i = 0; i < 100; ++i) {
      (void)arm.hold();
      (void)arm.set_mode(reference::Mode::Enabled);
      (void)arm.limit(1, reference::Mode::Enabled);
      (void)arm.servo_cp({});
    }
  }
  Required<reference::ArmLike> arm{*this, "Arm"};
};

struct LaneRow {
  const char* name;
  std::uint64_t underWay;  ///< how many commands the lane may have taken from the client's queues
};

class Unknown : public testing::TestWithParam<LaneRow> {
 protected:
  ConnectionReport report() const {
    const Report all = observe(console_, now());
    EXPECT_EQ(all.connections.size(), 1u);
    return all.connections.at(0);
  }
  /// Returns how many credits the commands without latest() have that are sent.
  static std::uint64_t credits() {
    std::uint64_t sum = 0;
    for (const CommandInfo& one : interfaceInfo<reference::ArmLike>().commands) {
      const std::string name = one.name;
      if (name == "hold" || name == "set_mode" || name == "limit") sum += one.depth;
    }
    return sum;
  }
  static constexpr std::uint64_t kLatest = 1;  // how many of them are latest()

  System system_;
  const std::unique_ptr<Child> names_ = system_.manager(), robot_ = system_.provider();
  Sender sender_;
  Manager console_{"console", system_.address()};
};

INSTANTIATE_TEST_SUITE_P(EachLane, Unknown,
                         testing::Values(LaneRow{"shm", 0},
                                         LaneRow{"frame", frame::Window::kFrames},
                                         LaneRow{"rpc", rpc::ProxyPort::kWindow}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Unknown, IsBoundedByWhatWasSent) {
  ASSERT_EQ(robot_->line(), "ready");
  console_.add("Sender", sender_);
  console_.start();
  console_.connect("Sender/Arm", "robot:PSM/Arm",
                   {.lane = Lane{GetParam().name}, .laneRequired = true, .patience = kPatience});
  for (int i = 0; i < 3; ++i) {  // the provider executes some, and its client hears of them
    sender_.sendAll();
    ASSERT_TRUE(eventually([&] { return report().underWay == 0; }));
  }
  robot_->signal(SIGSTOP);
  sender_.sendAll();
  for (int i = 0; i < 3000; ++i) {
    // This paces the sender, so that the lane takes most of them; nothing is judged by it.
    (void)sender_.arm.servo_cp({});
    std::this_thread::sleep_for(100us);
  }
  EXPECT_EQ(robot_->end(SIGKILL), -SIGKILL);
  ASSERT_TRUE(eventually([&] { return report().underWay == 0; }));
  const ConnectionReport seen = report();
  EXPECT_GE(seen.unknown, credits()) << "all of them were on their way";
  EXPECT_LE(seen.unknown, credits() + kLatest + GetParam().underWay);
  EXPECT_EQ(seen.sent, seen.commands() + seen.lost + seen.unknown);
  std::printf("%llu unknown\n", static_cast<unsigned long long>(seen.unknown));
  console_.stop();
}

}  // namespace
}  // namespace suture
