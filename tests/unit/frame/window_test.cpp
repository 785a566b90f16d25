#include <gtest/gtest.h>
#include <suture/lane/frame/window.h>

#include <deque>
#include <utility>

namespace suture::frame {
namespace {

/// Sends up to `most` of one end's frames to the other.
unsigned send(Window& from, Window& to, unsigned most = 2 * Window::kFrames) {
  unsigned count = 0;
  for (; count < most && from.isOpen(); ++count) {
    Header header{.kind = Kind::Event};
    from.sends(header);
    EXPECT_TRUE(to.takes(header));
  }
  return count;
}

void acknowledge(Window& from, Window& to) {
  Header header{.kind = Kind::Acknowledge};
  from.sends(header);
  EXPECT_TRUE(to.takes(header));
}

TEST(Window, AStoppedPeersFramesAreBounded) {
  Window near, far;
  EXPECT_EQ(send(near, far), Window::kFrames);
  EXPECT_EQ(send(near, far), 0u);
  EXPECT_TRUE(far.owesAcknowledgement());
  acknowledge(far, near);
  EXPECT_FALSE(far.owesAcknowledgement());
  EXPECT_EQ(send(near, far), Window::kFrames);
}

/// This sends a frame each millisecond over a link where each way takes a quarter of a second.
TEST(Window, ALongLinkLeavesNoGaps) {
  constexpr int kWay = 250;
  Window near, far;
  std::deque<std::pair<int, Header>> there, back;  // and when they arrive
  for (int now = 0; now < 3000; ++now) {
    for (; !there.empty() && there.front().first == now; there.pop_front()) {
      ASSERT_TRUE(far.takes(there.front().second));
    }
    for (; !back.empty() && back.front().first == now; back.pop_front()) {
      ASSERT_TRUE(near.takes(back.front().second));
    }
    if (far.owesAcknowledgement()) {
      back.emplace_back(now + kWay, Header{.kind = Kind::Acknowledge});
      far.sends(back.back().second);
    }
    ASSERT_TRUE(near.isOpen()) << now;
    there.emplace_back(now + kWay, Header{.kind = Kind::Event});
    near.sends(there.back().second);
  }
}

TEST(Window, FramesTheOtherWayAcknowledge) {
  Window near, far;
  for (int lap = 0; lap < 100; ++lap) {
    ASSERT_EQ(send(near, far, 1), 1u) << lap;
    ASSERT_EQ(send(far, near, 1), 1u) << lap;
    ASSERT_FALSE(near.owesAcknowledgement());
  }
}

TEST(Window, BelievesNoAcknowledgementOfTheUnsent) {
  Window window;
  EXPECT_FALSE(window.takes({.acknowledged = 1, .kind = Kind::Event}));
}

TEST(Window, TakesNoFrameTooMany) {
  Window window;
  for (unsigned i = 0; i < Window::kFrames; ++i) {
    ASSERT_TRUE(window.takes({.kind = Kind::Event})) << i;
  }
  EXPECT_TRUE(window.takes({.kind = Kind::Acknowledge}));
  EXPECT_FALSE(window.takes({.kind = Kind::Event}));
}

}  // namespace
}  // namespace suture::frame
