// These read the past of a provider's state, over every lane.
#include <suture/component/read_together.h>

#include "conformance/setup.h"

namespace conformance {
namespace {

using suture::Errc;

class History : public Conformance {
 protected:
  /// Sends the arm to `x` and returns the stamp under which it was seen there.
  suture::Time moveTo(double x) {
    suture::Time stamp;
    EXPECT_TRUE(suture::eventually([&] {
      client->with([&](Arm& port) {
        const auto pose = port.measured_cp();
        if (pose && pose->pose.translation().x() == x) {
          stamp = pose.stamp();
        } else if (!port.servo_cp(poseAt(x))) {
          ADD_FAILURE() << "servo_cp was refused";
        }
      });
      return stamp != suture::Time{};
    }));
    return stamp;
  }
};
class WireHistory : public History {};
/// The provider is called where its client runs, and so has no past.
class NoHistory : public History {};

TEST_P(WireHistory, AReadOfThePastTellsIt) {
  const suture::Time first = moveTo(1);
  const suture::Time second = moveTo(2);
  client->with([&](Arm& port) {
    const auto then = port.measured_cp.at(first);
    ASSERT_TRUE(then) << toString(then.error());
    EXPECT_EQ(then->pose.translation().x(), 1);
    EXPECT_EQ(then.stamp(), first);
    const auto justBefore = port.measured_cp.at(second - std::chrono::nanoseconds(1));
    ASSERT_TRUE(justBefore);
    EXPECT_LT(justBefore.stamp(), second);
    EXPECT_EQ(port.measured_cp.at(first - std::chrono::hours(1)).error(), Errc::NotYet);
    EXPECT_TRUE(port.measured_cp.delayed(suture::now() - first));
  });
}

TEST_P(NoHistory, AReadOfThenSaysSo) {
  const suture::Time first = moveTo(1);
  suture::pass(std::chrono::microseconds(1));
  client->with([&](Arm& port) { EXPECT_EQ(port.measured_cp.at(first).error(), Errc::TooOld); });
}

TEST_P(History, TwoReadsOfOneRowBelongTogether) {
  moveTo(3);
  EXPECT_TRUE(suture::eventually([&] {
    bool whole = false;
    client->with([&](Arm& port) {
      const auto row = readTogether(port.measured_cp, port.measured_js);
      whole = row.hasValue() && std::get<0>(*row).pose.translation().x() == 3;
    });
    return whole;
  }));
}

INSTANTIATE_TEST_SUITE_P(Lanes, History, testing::ValuesIn(laneRows()), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireHistory, testing::ValuesIn(wireRows(isQueued)), nameOf);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(NoHistory);  // over a lane that was added
INSTANTIATE_TEST_SUITE_P(Lanes, NoHistory, testing::ValuesIn(laneRows(&Row::runsInCallersThread)),
                         nameOf);

}  // namespace
}  // namespace conformance
