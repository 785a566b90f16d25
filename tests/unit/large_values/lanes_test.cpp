// These pass large values between two processes, by each lane.

#include <gtest/gtest.h>
#include <suture/lane/frame/frame_lane.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <memory>
#include <string>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/large_values/museum.h"

namespace large_values {
namespace {

using suture::eventually, suture::Lane;

/// This is `frame` as between builds that differ.
constexpr Lane kEncoded{"frame-encoded"};

/// Emits the picture that was hung last once more in each cycle.
struct Exhibition final : WallTask {
  ~Exhibition() override { stop(); }
  void run() override { (void)gallery.emit().hung(newest_); }
};

class LargeValuesBy : public testing::TestWithParam<Lane> {
 protected:
  LargeValuesBy() {
    for (suture::Manager* const one : {&museum_, &town_}) {
      one->addLane(std::make_unique<suture::frame::FrameLane>(kEncoded.name.data(),
                                                              suture::frame::Form::Encoded));
    }
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
  suture::rpc::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager museum_{"museum", names_.address()}, town_{"town", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(EachLane, LargeValuesBy,
                         testing::Values(Lane::Shm, Lane::Frame, kEncoded, Lane::Rpc),
                         [](const auto& one) {
                           std::string name = toString(one.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

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

}  // namespace
}  // namespace large_values
