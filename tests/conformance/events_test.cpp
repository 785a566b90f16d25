// These emit events, from task and device to task and device.
#include <limits>

#include "conformance/setup.h"

namespace conformance {
namespace {

class Events : public Conformance {};
class WireEvents : public Conformance {};

TEST_P(Events, ArriveWithAllTheirValues) {
  arm->emitSoon([](Ports ports) { ports.arm.emit().stopped(); });
  EXPECT_TRUE(client->await([](const Received& received) { return received.stops == 1; }));
  arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().arrived(poseAt(4))); });
  EXPECT_TRUE(client->await(
      [](const Received& received) { return received.arrivals == std::vector<double>{4}; }));
  arm->emitSoon([](Ports ports) { EXPECT_TRUE(ports.arm.emit().moved(poseAt(4), 0.25)); });
  EXPECT_TRUE(client->await([](const Received& received) {
    return received.moves == std::vector<std::pair<double, double>>{{4, 0.25}};
  }));
}

TEST_P(WireEvents, ArriveInTheirOrder) {
  for (int x = 1; x <= 50; ++x) {
    arm->emitSoon([x](Ports ports) { EXPECT_TRUE(ports.arm.emit().arrived(poseAt(x))); });
    ASSERT_TRUE(client->await([x](const Received& received) {
      return received.arrivals.size() == static_cast<std::size_t>(x) &&
             received.arrivals.back() == x;
    }));
  }
}

// An enumerator without a declaration, or a NaN, must not reach a handler as if it were a value.
TEST_P(Events, InvalidValuesReachNoHandler) {
  arm->emitSoon([](Ports ports) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ports.arm.emit().moved(poseAt(1), none).error(), suture::Errc::Invalid);
    EXPECT_EQ(ports.arm.emit().arrived(poseAt(none)).error(), suture::Errc::Invalid);
    EXPECT_EQ(ports.arm.emit().mode(static_cast<Mode>(77)).error(), suture::Errc::Invalid);
    EXPECT_TRUE(ports.arm.emit().moved(poseAt(4), 0.25));
  });
  EXPECT_TRUE(client->await([](const Received& received) { return !received.moves.empty(); }));
  EXPECT_TRUE(client->await([](const Received& received) {
    return received.arrivals.empty() && received.modes.empty() && received.moves.size() == 1;
  }));
}

// A client that was told of a mode that no longer holds, and of nothing after it, would act on it
// for ever.
TEST_P(Events, AFullQueueKeepsTheLatchedValue) {
  constexpr std::size_t kEmitted = 200;
  client->with([this](Arm& remote) {
    arm->emitSoon([](Ports ports) {
      for (std::size_t i = 1; i < kEmitted; ++i) {
        EXPECT_TRUE(ports.arm.emit().mode(Mode::Disabled));
      }
      EXPECT_TRUE(ports.arm.emit().mode(Mode::Enabled));
    });
    // A cycle takes its commands before it emits: the second answer comes behind the last event.
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(remote.hold.start().within(suture::kPatience));
  });
  EXPECT_TRUE(client->await([](const Received& received) {
    return !received.modes.empty() && received.modes.back() == Mode::Enabled;
  }));
  EXPECT_TRUE(client->await([](const Received& received) {
    return received.modes.size() < kEmitted;
  })) << "the queue was never full";
}

INSTANTIATE_TEST_SUITE_P(Lanes, Events, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireEvents, testing::ValuesIn(wireRows()), nameOf);

}  // namespace
}  // namespace conformance
