// Which connections of a client share a link.
#include <gtest/gtest.h>
#include <suture/lane/frame/frame_links.h>
#include <suture/loop/event_port.h>

#include "support/eventually.h"
#include "support/pass.h"
#include "support/stepped.h"
#include "unit/rpc/socket_pair.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

class FrameLinksTest : public testing::Test {
 public:
  ~FrameLinksTest() noexcept override {}

 protected:
  const TestClock clock{steppedOptions()};
  rpc::EventPort port;
  frame::LaneThread lane;
  FrameLinks links{lane};
};

TEST_F(FrameLinksTest, AreSharedByWhoSaysTheSame) {
  const std::string name = links.client("robot", 1s);
  EXPECT_EQ(links.client("robot", 1s), name);
  EXPECT_NE(links.client("robot", 2s), name);  // its socket has another bound
  EXPECT_NE(links.client("camera", 1s), name);
  links.rename("robot");
  EXPECT_NE(links.client("robot", 1s), name);
}

TEST_F(FrameLinksTest, AreFoundByWhoComesBeforeTheirSocketAndByWhoComesLater) {
  auto early = links.find("robot", 7);
  EXPECT_FALSE(early.poll(port.scope()));
  auto sockets = rpc::makeSocketPair();
  const auto link = links.open("robot", 7, rpc::ByteStream(kj::mv(sockets.ours)));
  EXPECT_EQ(early.wait(port.scope()), link);
  EXPECT_EQ(links.find("robot", 7).wait(port.scope()), link);
  EXPECT_FALSE(links.find("camera", 7).poll(port.scope()));  // another provider's
}

// The provider may not have noticed: nothing of what it joins to that link would arrive.
TEST_F(FrameLinksTest, ThatHaveEndedAreNotMeantAnyMore) {
  const std::string name = links.client("robot", 1s);
  auto sockets = rpc::makeSocketPair();
  auto link = links.open("robot", 7, rpc::ByteStream(kj::mv(sockets.ours)));
  {
    const auto hold = links.hold("robot");
    link.reset();
    lane.doorbell()->ring();
    pass(20ms);
    EXPECT_EQ(links.client("robot", 1s), name);
  }
  EXPECT_TRUE(eventually([&] { return links.client("robot", 1s) != name; }));
}

TEST_F(FrameLinksTest, ThatNobodyWaitsForAnyMoreAreForgotten) {
  const std::string name = links.client("robot", 1s);
  { auto given = links.find("robot", 7); }
  EXPECT_NE(links.client("robot", 1s), name);
}

}  // namespace
}  // namespace suture
