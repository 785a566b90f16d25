// A value within its bounds may still be larger than a message of Cap'n Proto. It fails alone, on
// each lane that sends messages.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/ledger.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/large_values/canvas.suture.h"
#include "unit/large_values/lanes.h"

namespace large_values {
namespace {

using suture::Errc, suture::eventually, suture::Lane;

/// A message has room for so many words, and a dot has one.
constexpr std::uint32_t kLimit = 2u << 20;
constexpr std::uint32_t kTooMany = 2'400'000, kFew = 10;

Dots dotted(std::uint32_t dots) { return {std::vector<Dot>(dots)}; }

struct Painter final : suture::EventTask, Canvas {
  ~Painter() override { stop(); }
  void run() override {}
  void resize(std::uint32_t dots) override { paint(dotted(dots)); }
  void paint(const Dots& dots) override {
    painting_ = dots;
    (void)canvas.emit().painted(dots);
  }
  const Dots& painting() const override { return painting_; }
  Dots copy(std::uint32_t dots) const override { return dotted(dots); }

  suture::Provided<Canvas> canvas{*this, "Canvas", *this};

 private:
  Dots painting_;
};

struct Viewer final : suture::Device {
  Viewer() {
    canvas.on().painted([this](const Dots& dots) { heard.push_back(dots.dots.size()); });
  }
  suture::Required<Canvas> canvas{*this, "Canvas"};
  std::vector<std::size_t> heard;
};

class MessagesBy : public testing::TestWithParam<Lane> {
 protected:
  MessagesBy() {
    for (suture::Manager* const one : {&studio_, &town_}) addEncodedLane(*one);
    studio_.add("Painter", painter_);
    studio_.start();
    town_.add("Viewer", viewer_);
    town_.add("Neighbour", neighbour_);
    town_.start();
    // A sanitizer makes a thread that converts such values slow, which is not to count as hung.
    constexpr suture::Duration kSilence = std::chrono::seconds(60);
    for (const std::string one : {"Viewer", "Neighbour"}) {
      town_.connect(one + "/Canvas", "studio:Painter/Canvas",
                    {.lane = GetParam(), .laneRequired = true, .contract = {.silence = kSilence}});
    }
  }
  ~MessagesBy() override {
    town_.stop();
    studio_.stop();
  }
  void SetUp() override { channels_ = town_.channels(); }
  /// Both connections are those of the beginning, and carry what fits.
  void TearDown() override {
    for (const auto& one : channels_) {
      EXPECT_EQ(one->status, suture::ChannelStatus::Connected) << one->name();
    }
    for (Viewer* const one : {&viewer_, &neighbour_}) {
      ASSERT_EQ(outcomeOf(one->canvas.copy.start(kFew).within(suture::kPatience)), Errc{});
    }
  }
  const suture::Channel& channelOf(const std::string& component) const {
    const auto isIts = [&](const auto& one) {
      return one->name().find(component) != std::string::npos;
    };
    return **std::find_if(channels_.begin(), channels_.end(), isIts);
  }
  Errc outcomeOf(const auto& result) { return result.has_value() ? Errc{} : result.error(); }

  const suture::TemporaryDirectory directory_;
  Painter painter_;
  Viewer viewer_, neighbour_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager studio_{"studio", names_.address()}, town_{"town", names_.address()};
  std::vector<std::shared_ptr<suture::Channel>> channels_;
};

TEST_P(MessagesBy, ATooLargeCommandIsNotSent) {
  auto& paint = viewer_.canvas.paint;
  for (int lap = 0; lap < 3; ++lap) {
    ASSERT_EQ(outcomeOf(paint.start(dotted(kTooMany)).within(suture::kPatience)), Errc::TooLarge);
  }
  for (int lap = 0; lap < 3; ++lap) {
    ASSERT_TRUE(eventually([&] { return paint(dotted(kTooMany)).has_value(); }))
        << "a credit is back when the command can no longer arrive";
  }
  ASSERT_TRUE(eventually([&] { return paint(dotted(kFew)).has_value(); }));
  const suture::Ledger& ledger = *channelOf("Viewer").terms.ledger;
  EXPECT_TRUE(eventually([&] { return ledger.sums().underWay == 0; }))
      << "a command that was not sent has its outcome";
  EXPECT_EQ(ledger.sums().tally.refused, 6U);
  EXPECT_EQ(ledger.sums().tally.executed, 1U);
}

// The peer counts what frames a message, and the references that it follows to read one.
TEST_P(MessagesBy, NearlyTooLargeMessagesArriveOrFail) {
  const auto isToldOf = [](Errc outcome) { return outcome == Errc{} || outcome == Errc::TooLarge; };
  std::vector<Errc> painted, copied;
  for (std::uint32_t dots = kLimit - 26; dots < kLimit; dots += 2) {
    painted.push_back(
        outcomeOf(viewer_.canvas.paint.start(dotted(dots)).within(suture::kPatience)));
    copied.push_back(outcomeOf(viewer_.canvas.copy.start(dots).within(suture::kPatience)));
    ASSERT_TRUE(isToldOf(painted.back())) << toString(painted.back()) << " for " << dots;
    ASSERT_TRUE(isToldOf(copied.back())) << toString(copied.back()) << " for " << dots;
  }
  for (const auto& outcomes : {painted, copied}) {
    EXPECT_EQ(outcomes.front(), Errc{}) << "the sizes are not those near the limit";
    EXPECT_EQ(outcomes.back(), Errc::TooLarge) << "the sizes are not those near the limit";
  }
}

TEST_P(MessagesBy, ATooLargeAnswerIsMissing) {
  auto& copy = viewer_.canvas.copy;
  ASSERT_EQ(outcomeOf(copy.start(kTooMany).within(suture::kPatience)), Errc::TooLarge);
  ASSERT_EQ(outcomeOf(copy.start(kFew).within(suture::kPatience)), Errc{});
}

TEST_P(MessagesBy, ATooLargeEventIsDropped) {
  for (const std::uint32_t dots : {kTooMany, kFew}) {
    ASSERT_EQ(outcomeOf(viewer_.canvas.resize.start(dots).within(suture::kPatience)), Errc{});
  }
  ASSERT_TRUE(eventually([&] {
    viewer_.processEvents();
    return !viewer_.heard.empty();
  }));
  EXPECT_EQ(viewer_.heard, std::vector<std::size_t>{kFew});
  ASSERT_TRUE(eventually([&] { return channels_.at(0)->counts->told.load().eventsDropped == 1; }));
}

TEST_P(MessagesBy, ATooLargeRowHasNoValue) {
  auto& painting = viewer_.canvas.painting;
  const auto sizeBecomes = [&](std::size_t size) {
    return eventually([&] {
      const auto newest = painting();
      return newest && newest->dots.size() == size;
    });
  };
  for (const std::uint32_t few : {kFew, 2 * kFew}) {
    ASSERT_EQ(outcomeOf(viewer_.canvas.resize.start(few).within(suture::kPatience)), Errc{});
    ASSERT_TRUE(sizeBecomes(few));
    ASSERT_EQ(outcomeOf(viewer_.canvas.resize.start(kTooMany).within(suture::kPatience)), Errc{});
    ASSERT_TRUE(eventually([&] { return painting().error() == Errc::TooLarge; }));
  }
}

INSTANTIATE_TEST_SUITE_P(EachLane, MessagesBy, testing::Values(kEncoded, Lane::Rpc), nameOf);

}  // namespace
}  // namespace large_values
