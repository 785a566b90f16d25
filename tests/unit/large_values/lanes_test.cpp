// These pass large values between two processes, by each lane.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/large_values/lanes.h"
#include "unit/large_values/museum.h"

namespace large_values {
namespace {

using suture::eventually, suture::Lane;

/// Emits the picture that was hung last once more in each cycle.
struct Exhibition final : WallTask {
  ~Exhibition() override { stop(); }
  void run() override { (void)gallery.emit().hung(newest_); }
};

class LargeValuesBy : public testing::TestWithParam<Lane> {
 protected:
  LargeValuesBy() {
    for (suture::Manager* const one : {&museum_, &town_}) addEncodedLane(*one);
    museum_.add("Wall", wall_);
    museum_.start();
    town_.add("Visitor", visitor_);
    town_.start();
    town_.connect("Visitor/Gallery", "museum:Wall/Gallery",
                  {.lane = GetParam(), .laneRequired = true});
  }
  ~LargeValuesBy() override {
    town_.stop();
    museum_.stop();
  }

  const suture::TemporaryDirectory directory_;
  Exhibition wall_;
  Visitor visitor_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager museum_{"museum", names_.address()}, town_{"town", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(EachLane, LargeValuesBy,
                         testing::Values(Lane::Shm, Lane::Frame, kEncoded, Lane::Rpc), nameOf);

TEST_P(LargeValuesBy, AreSentAnsweredReadAndHeard) {
  for (const std::uint8_t shade : {20, 40, 60}) {
    ASSERT_TRUE(visitor_.gallery.hang.start(grey(shade)).within(suture::kPatience).has_value());
    const auto answer = visitor_.gallery.dimmed.start(grey(shade)).within(suture::kPatience);
    ASSERT_TRUE(answer.has_value());
    EXPECT_EQ(answer->pixels, grey(shade / 2).pixels);
    EXPECT_TRUE(eventually([&] {
      const auto picture = visitor_.gallery.newest();
      return picture && picture->pixels == grey(shade).pixels;
    }));
    EXPECT_TRUE(eventually([&] {
      visitor_.processEvents();
      return visitor_.heard == shade;
    }));
  }
}

// A smaller value must not show what an earlier, larger one has left behind.
TEST_P(LargeValuesBy, HaveAnySizeFromOneToNext) {
  for (const std::size_t size : {kPixels, std::size_t{120}, kPixels / 2, std::size_t{0}, kPixels}) {
    Picture picture{std::vector<std::uint8_t>(size, 80)};
    if (size > 0) picture.pixels.back() = 81;
    ASSERT_TRUE(visitor_.gallery.hang.start(picture).within(suture::kPatience).has_value());
    EXPECT_TRUE(eventually([&] {
      const auto newest = visitor_.gallery.newest();
      return newest && newest->pixels == picture.pixels;
    })) << size;
    EXPECT_TRUE(eventually([&] {
      visitor_.processEvents();
      return visitor_.size == size;
    })) << size;
  }
}

/// SmallValuesBy has one connection over a wire, and counts all of its bytes.
using SmallValuesBy = LargeValuesBy;

INSTANTIATE_TEST_SUITE_P(EachWire, SmallValuesBy, testing::Values(Lane::Frame, kEncoded, Lane::Rpc),
                         nameOf);

TEST_P(SmallValuesBy, TakeLittleOfALargeRoom) {
  const Picture picture{std::vector<std::uint8_t>(120, 8)};
  const auto channel = town_.channels().at(0);
  const auto sent = [&] { return channel->bytesSent.load(); };
  const auto received = [&] { return channel->bytesReceived.load(); };
  ASSERT_TRUE(visitor_.gallery.hang.start(picture).within(suture::kPatience).has_value());
  // Large ones that were emitted before are on their way until then, and are counted, over rpc,
  // when the next command is sent.
  ASSERT_TRUE(eventually([&] {
    visitor_.processEvents();
    return visitor_.size == picture.pixels.size();
  }));
  ASSERT_TRUE(visitor_.gallery.dimmed.start(picture).within(suture::kPatience).has_value());
  const auto sentBefore = sent(), receivedBefore = received();
  constexpr unsigned kTimes = 4;
  for (unsigned i = 0; i < kTimes; ++i) {
    ASSERT_TRUE(visitor_.gallery.dimmed.start(picture).within(suture::kPatience).has_value());
  }
  EXPECT_LT(sent() - sentBefore, kTimes * kPixels / 2);
  EXPECT_LT(received() - receivedBefore, kTimes * kPixels / 2);
}

}  // namespace
}  // namespace large_values
