// A component fills the list of a command or an event where it leaves from.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/callback_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/allocations.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/large_values/lanes.h"
#include "unit/large_values/screen.suture.h"

namespace large_values {
namespace {

using suture::Errc, suture::eventually, suture::Lane;
using Room = std::span<std::uint8_t>;

constexpr std::size_t kRoom = 65536;

/// Writes `count` pixels of the shade, and says that it has.
auto shaded(std::uint8_t shade, std::size_t count = kRoom) {
  return [shade, count](Room room) {
    std::ranges::fill(room.first(count), shade);
    return count;
  };
}

Frame frameOf(std::uint32_t number, std::uint8_t shade, std::size_t count = kRoom) {
  return {number, std::vector<std::uint8_t>(count, shade)};
}

/// Both kinds of provider have this in common.
struct Shows : Screen {
  void show(const Frame& frame) override { seen.push_back(frame); }
  void replace(const Frame& frame) override { seen.push_back(frame); }
  void show_both(const FramePair& frames) override {
    seen.push_back(frames.left);
    seen.push_back(frames.right);
  }
  std::vector<Frame> seen;
};

struct ScreenDevice final : suture::Device, Shows {
  suture::Provided<Screen> screen{*this, "Screen", *this};
};

/// The test's thread is its own, and decides when it has a cycle.
struct ScreenTask final : suture::CallbackTask, Shows {
  ~ScreenTask() override { stop(); }
  void run() override {}
  suture::Provided<Screen> screen{*this, "Screen", *this};
};

struct Camera final : suture::Device {
  Camera() {
    screen.on().shown([this](const Frame& frame) { heard.push_back(frame); });
    screen.on().newest([this](const Frame& frame) { heard.push_back(frame); });
    screen.on().both([this](const FramePair& frames) { heard.push_back(frames.right); });
  }
  suture::Required<Screen> screen{*this, "Screen"};
  std::vector<Frame> heard;
};

/// Connects a camera to a screen in another process, or in what is one to them.
class LoansBy : public testing::TestWithParam<Lane> {
 protected:
  LoansBy() {
    for (suture::Manager* const one : {&hall_, &booth_}) addEncodedLane(*one);
    hall_.add("Screen", screen_);
    hall_.start();
    booth_.add("Camera", camera_);
    booth_.start();
    booth_.connect("Camera/Screen", "hall:Screen/Screen",
                   {.lane = GetParam(), .laneRequired = true});
    EXPECT_TRUE(screen_.trigger());  // the next events go to the subscriber
  }
  ~LoansBy() override {
    booth_.stop();
    hall_.stop();
  }

  /// Runs cycles of both until the screen has seen so many, and the camera has heard so many.
  [[nodiscard]] bool arrive(std::size_t seen, std::size_t heard) {
    return eventually([&] {
      EXPECT_TRUE(screen_.trigger());
      camera_.processEvents();
      return screen_.seen.size() >= seen && camera_.heard.size() >= heard;
    });
  }

  const suture::TemporaryDirectory directory_;
  ScreenTask screen_;
  Camera camera_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager hall_{"hall", names_.address()}, booth_{"booth", names_.address()};
};

INSTANTIATE_TEST_SUITE_P(EachLane, LoansBy,
                         testing::Values(Lane::Shm, Lane::Frame, kEncoded, Lane::Rpc), nameOf);

TEST_P(LoansBy, CarryCommandsOfAnySize) {
  const std::size_t sizes[] = {kRoom, 3, 0, kRoom / 2};
  for (std::uint32_t i = 0; i < std::size(sizes); ++i) {
    ASSERT_TRUE(camera_.screen.show.loan<&FrameSlot::pixels>({i, {}}, shaded(7, sizes[i])));
    ASSERT_TRUE(arrive(i + 1, 0));
    EXPECT_EQ(screen_.seen[i], frameOf(i, 7, sizes[i]));
  }
  ASSERT_TRUE(camera_.screen.replace.loan<&FrameSlot::pixels>({9, {}}, shaded(8)));
  ASSERT_TRUE(arrive(std::size(sizes) + 1, 0));
  EXPECT_EQ(screen_.seen.back(), frameOf(9, 8));
}

TEST_P(LoansBy, CarryEventsOfAnySize) {
  const std::size_t sizes[] = {kRoom, 3, 0, kRoom / 2};
  for (std::uint32_t i = 0; i < std::size(sizes); ++i) {
    ASSERT_TRUE(screen_.screen.emit().shown.loan<&FrameSlot::pixels>({i, {}}, shaded(7, sizes[i])));
    ASSERT_TRUE(arrive(0, i + 1));
    EXPECT_EQ(camera_.heard[i], frameOf(i, 7, sizes[i]));
  }
  ASSERT_TRUE(screen_.screen.emit().newest.loan<&FrameSlot::pixels>({9, {}}, shaded(8)));
  ASSERT_TRUE(arrive(0, std::size(sizes) + 1));
  EXPECT_EQ(camera_.heard.back(), frameOf(9, 8));
}

TEST_P(LoansBy, FillAListWithinAMember) {
  FramePair pair{frameOf(1, 10, 5), {2, {}}};
  ASSERT_TRUE(
      (camera_.screen.show_both.loan<&FramePairSlot::right, &FrameSlot::pixels>(pair, shaded(20))));
  ASSERT_TRUE((screen_.screen.emit().both.loan<&FramePairSlot::right, &FrameSlot::pixels>(
      pair, shaded(30))));
  ASSERT_TRUE(arrive(2, 1));
  EXPECT_EQ(screen_.seen[0], frameOf(1, 10, 5));
  EXPECT_EQ(screen_.seen[1], frameOf(2, 20));
  EXPECT_EQ(camera_.heard[0], frameOf(2, 30));
}

// A thread has two blocks for values that are copied, so three places are no copies.
TEST_P(LoansBy, AreWrittenWhereTheyLeaveFrom) {
  std::set<const std::uint8_t*> sent, emitted;
  const auto notedIn = [](std::set<const std::uint8_t*>& places) {
    return [&places](Room room) {
      EXPECT_EQ(room.size(), kRoom);
      places.insert(room.data());
      return shaded(1)(room);
    };
  };
  for (std::uint32_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(camera_.screen.show.loan<&FrameSlot::pixels>({i, {}}, notedIn(sent)));
    ASSERT_TRUE(screen_.screen.emit().shown.loan<&FrameSlot::pixels>({i, {}}, notedIn(emitted)));
  }
  EXPECT_EQ(sent.size(), 3u);
  EXPECT_EQ(emitted.size(), 3u);
  EXPECT_TRUE(arrive(3, 3));
}

TEST_P(LoansBy, SendNothingThatTheContractRefuses) {
  auto& show = camera_.screen.show;
  auto& shown = screen_.screen.emit().shown;
  const auto tooMany = [](Room room) { return room.size() + 1; };
  auto& replace = camera_.screen.replace;
  for (int i = 0; i < 5; ++i) {  // more than either queue has room for
    EXPECT_EQ(replace.loan<&FrameSlot::pixels>({1, {}}, tooMany).error(), Errc::TooLarge);
    EXPECT_EQ(replace.loan<&FrameSlot::pixels>({1, {}}, shaded(201)).error(), Errc::Invalid);
    EXPECT_EQ(show.loan<&FrameSlot::pixels>({1, {}}, tooMany).error(), Errc::TooLarge);
    EXPECT_EQ(shown.loan<&FrameSlot::pixels>({1, {}}, tooMany).error(), Errc::TooLarge);
    EXPECT_EQ(show.loan<&FrameSlot::pixels>({1, {}}, shaded(201)).error(), Errc::Invalid);
    EXPECT_EQ(shown.loan<&FrameSlot::pixels>({1, {}}, shaded(201)).error(), Errc::Invalid);
  }
  ASSERT_TRUE(show.loan<&FrameSlot::pixels>({2, {}}, shaded(200)));
  ASSERT_TRUE(shown.loan<&FrameSlot::pixels>({2, {}}, shaded(200)));
  ASSERT_TRUE(arrive(1, 1));
  EXPECT_EQ(screen_.seen, std::vector{frameOf(2, 200)});
  EXPECT_EQ(camera_.heard, std::vector{frameOf(2, 200)});
}

TEST_P(LoansBy, SendNothingIfTheirFillThrows) {
  auto& show = camera_.screen.show;
  auto& shown = screen_.screen.emit().shown;
  const auto fails = [](Room) -> std::size_t { throw std::runtime_error("no light"); };
  for (int i = 0; i < 5; ++i) {
    EXPECT_THROW(show.loan<&FrameSlot::pixels>({1, {}}, fails), std::runtime_error);
    EXPECT_THROW(camera_.screen.replace.loan<&FrameSlot::pixels>({1, {}}, fails),
                 std::runtime_error);
    EXPECT_THROW(shown.loan<&FrameSlot::pixels>({1, {}}, fails), std::runtime_error);
  }
  ASSERT_TRUE(show.loan<&FrameSlot::pixels>({2, {}}, shaded(5)));
  ASSERT_TRUE(shown.loan<&FrameSlot::pixels>({2, {}}, shaded(6)));
  ASSERT_TRUE(arrive(1, 1));
  EXPECT_EQ(screen_.seen, std::vector{frameOf(2, 5)});
  EXPECT_EQ(camera_.heard, std::vector{frameOf(2, 6)});
}

TEST_P(LoansBy, AllowNoOtherCommandOfTheirInterface) {
  auto& show = camera_.screen.show;
  ASSERT_TRUE(show.loan<&FrameSlot::pixels>({1, {}}, [&](Room room) {
    EXPECT_EQ(show(frameOf(2, 1)).error(), Errc::OnLoan);
    EXPECT_EQ(camera_.screen.replace(frameOf(3, 1)).error(), Errc::OnLoan);
    EXPECT_EQ(show.start(frameOf(4, 1)).within(suture::kPatience).error(), Errc::OnLoan);
    EXPECT_EQ(show.loan<&FrameSlot::pixels>({5, {}}, shaded(1)).error(), Errc::OnLoan);
    return shaded(9)(room);
  }));
  ASSERT_TRUE(show(frameOf(6, 4)));
  ASSERT_TRUE(arrive(2, 0));
  EXPECT_EQ(screen_.seen, (std::vector{frameOf(1, 9), frameOf(6, 4)}));
}

TEST_P(LoansBy, OfEventsAllowOtherEvents) {
  auto& shown = screen_.screen.emit().shown;
  ASSERT_TRUE(shown.loan<&FrameSlot::pixels>({1, {}}, [&](Room room) {
    EXPECT_TRUE(shown(frameOf(2, 2)));
    EXPECT_TRUE(shown.loan<&FrameSlot::pixels>({3, {}}, shaded(3)));
    return shaded(1)(room);
  }));
  ASSERT_TRUE(arrive(0, 3));
  EXPECT_EQ(camera_.heard, (std::vector{frameOf(2, 2), frameOf(3, 3), frameOf(1, 1)}));
}

TEST_P(LoansBy, AreLostWithTheirConnection) {
  EXPECT_EQ(camera_.screen.show
                .loan<&FrameSlot::pixels>({1, {}},
                                          [&](Room room) {
                                            booth_.disconnect("Camera/Screen");
                                            camera_.processEvents();
                                            return shaded(1)(room);
                                          })
                .error(),
            Errc::Lost);
  EXPECT_EQ(camera_.screen.show.loan<&FrameSlot::pixels>({1, {}}, shaded(1)).error(),
            Errc::NotConnected);
}

TEST_P(LoansBy, AreRefusedOrDroppedWithoutRoom) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(camera_.screen.show.loan<&FrameSlot::pixels>({i, {}}, shaded(1)));
  }
  EXPECT_EQ(camera_.screen.show.loan<&FrameSlot::pixels>({3, {}}, shaded(1)).error(), Errc::Full);
  EXPECT_TRUE(arrive(3, 0));
}

// --- in one process

class LoansWithin : public testing::Test {
 protected:
  LoansWithin() {
    manager_.add("Task", task_);
    manager_.add("Device", device_);
    for (Camera* const one : {&ofTask_, &second_, &ofDevice_}) {
      manager_.add(one == &ofTask_ ? "OfTask" : one == &second_ ? "Second" : "OfDevice", *one);
    }
    manager_.connect("OfTask/Screen", "Task/Screen");
    manager_.connect("OfDevice/Screen", "Device/Screen");
    manager_.start();
    EXPECT_TRUE(task_.trigger());
  }
  ~LoansWithin() override { manager_.stop(); }

  ScreenTask task_;
  ScreenDevice device_;
  Camera ofTask_, second_, ofDevice_;
  suture::Manager manager_{"hall"};
};

TEST_F(LoansWithin, ReachATaskWithoutAllocation) {
  const auto fill = shaded(3);
  const Frame rest{1, {}};
  ASSERT_TRUE(ofTask_.screen.show.loan<&FrameSlot::pixels>(rest, fill));
  const auto before = suture::allocations();
  ASSERT_TRUE(ofTask_.screen.show.loan<&FrameSlot::pixels>(rest, fill));
  ASSERT_TRUE(task_.screen.emit().shown.loan<&FrameSlot::pixels>(rest, fill));
  if (suture::countsAllocations()) {
    EXPECT_EQ(suture::allocations(), before);
  }
  EXPECT_TRUE(task_.trigger());
  ofTask_.processEvents();
  EXPECT_EQ(task_.seen, (std::vector{frameOf(1, 3), frameOf(1, 3)}));
  EXPECT_EQ(ofTask_.heard, std::vector{frameOf(1, 3)});
}

TEST_F(LoansWithin, RunInTheCallersThread) {
  auto& show = ofDevice_.screen.show;
  ASSERT_TRUE(show.loan<&FrameSlot::pixels>({1, {}}, shaded(3, 10)));
  EXPECT_EQ(show.loan<&FrameSlot::pixels>({2, {}}, shaded(201)).error(), Errc::Invalid);
  EXPECT_EQ(show.loan<&FrameSlot::pixels>({2, {}}, [](Room) { return kRoom + 1; }).error(),
            Errc::TooLarge);
  ASSERT_TRUE(device_.screen.emit().shown.loan<&FrameSlot::pixels>({4, {}}, shaded(5)));
  ofDevice_.processEvents();
  EXPECT_EQ(device_.seen, std::vector{frameOf(1, 3, 10)});
  EXPECT_EQ(ofDevice_.heard, std::vector{frameOf(4, 5)});
}

TEST_F(LoansWithin, OfADeviceAllowNoOtherCommand) {
  auto& show = ofDevice_.screen.show;
  ASSERT_TRUE(show.loan<&FrameSlot::pixels>({1, {}}, [&](Room room) {
    EXPECT_EQ(show(frameOf(2, 1)).error(), Errc::OnLoan);
    EXPECT_EQ(show.loan<&FrameSlot::pixels>({3, {}}, shaded(1)).error(), Errc::OnLoan);
    return shaded(9, 10)(room);
  }));
  EXPECT_EQ(device_.seen, std::vector{frameOf(1, 9, 10)});
}

TEST_F(LoansWithin, OfADeviceEndWithTheirConnection) {
  const auto fill = [&](Room room) {
    manager_.disconnect("OfDevice/Screen");
    ofDevice_.processEvents();
    return shaded(1)(room);
  };
  EXPECT_EQ(ofDevice_.screen.show.loan<&FrameSlot::pixels>({1, {}}, fill).error(), Errc::Lost);
  EXPECT_EQ(device_.seen, std::vector<Frame>{});
}

TEST_F(LoansWithin, ReachNoProviderThatStopsMeanwhile) {
  const auto fill = [&](Room room) {
    task_.stop();
    return shaded(1)(room);
  };
  EXPECT_EQ(ofTask_.screen.show.loan<&FrameSlot::pixels>({1, {}}, fill).error(), Errc::Lost);
  EXPECT_EQ(ofTask_.screen.show.loan<&FrameSlot::pixels>({2, {}}, shaded(1)).error(), Errc::Lost);
}

TEST_F(LoansWithin, OfAnEventNeedItsThread) {
  bool filled = false;
  std::thread([&] {
    const auto fill = [&](Room) { return filled = true, std::size_t{0}; };
    EXPECT_EQ(task_.screen.emit().shown.loan<&FrameSlot::pixels>({1, {}}, fill).error(),
              Errc::WrongThread);
  }).join();
  EXPECT_FALSE(filled);
}

TEST_F(LoansWithin, AreCopiedForSeveralSubscribers) {
  manager_.connect("Second/Screen", "Task/Screen");
  EXPECT_TRUE(task_.trigger());
  ASSERT_TRUE(task_.screen.emit().shown.loan<&FrameSlot::pixels>({1, {}}, shaded(5)));
  for (Camera* const one : {&ofTask_, &second_}) {
    one->processEvents();
    EXPECT_EQ(one->heard, std::vector{frameOf(1, 5)});
  }
}

TEST_F(LoansWithin, ReachADirectHandler) {
  std::vector<Frame> direct;
  ofTask_.processEvents();  // it takes over its connection
  ASSERT_TRUE(
      ofTask_.screen.on().shown.direct([&](const Frame& frame) { direct.push_back(frame); }));
  EXPECT_TRUE(task_.trigger());
  ASSERT_TRUE(task_.screen.emit().shown.loan<&FrameSlot::pixels>({1, {}}, shaded(5)));
  EXPECT_EQ(direct, std::vector{frameOf(1, 5)});
}

TEST_F(LoansWithin, OfEventsWithoutASubscriberGoNowhere) {
  manager_.disconnect("OfTask/Screen");
  EXPECT_TRUE(task_.trigger());
  EXPECT_TRUE(task_.screen.emit().shown.loan<&FrameSlot::pixels>({1, {}}, shaded(5)));
}

TEST_F(LoansWithin, DropAnEventWithoutRoom) {
  std::uint32_t emitted = 0;
  const auto dropped = [&] {
    std::uint64_t sum = 0;
    for (const auto& channel : manager_.channels()) sum += channel->events.dropped();
    return sum;
  };
  while (dropped() == 0 && emitted < 100) {
    EXPECT_TRUE(task_.screen.emit().shown.loan<&FrameSlot::pixels>({emitted++, {}}, shaded(5)));
  }
  EXPECT_EQ(dropped(), 1u);
  ofTask_.processEvents();
  EXPECT_EQ(ofTask_.heard.size(), emitted - 1);
}

}  // namespace
}  // namespace large_values
