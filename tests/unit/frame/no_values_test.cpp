// A contract without any values has nothing to encode, and works on each lane all the same.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/temporary_directory.h"
#include "unit/frame/latch.suture.h"
#include "unit/large_values/lanes.h"

namespace latches {
namespace {

struct Door final : suture::EventTask, Latch {
  ~Door() override { stop(); }
  void run() override {}
  void close() override { latch.emit().closed(); }
  suture::Provided<Latch> latch{*this, "Latch", *this};
};

struct Keeper final : suture::Device {
  Keeper() {
    latch.on().closed([this] { ++heard; });
  }
  suture::Required<Latch> latch{*this, "Latch"};
  int heard = 0;
};

class NoValues : public testing::TestWithParam<suture::Lane> {};

INSTANTIATE_TEST_SUITE_P(EachLane, NoValues,
                         testing::Values(suture::Lane::Shm, suture::Lane::Frame,
                                         large_values::kEncoded, suture::Lane::Rpc),
                         large_values::nameOf);

TEST_P(NoValues, CommandsAndEventsArrive) {
  const suture::TemporaryDirectory directory;
  suture::loop::ControlThread control;
  const suture::GlobalManager names(control, "unix:" + directory.file("m.sock"));
  Door door;
  Keeper keeper;
  suture::Manager house("house", names.address()), lodge("lodge", names.address());
  for (suture::Manager* const one : {&house, &lodge}) large_values::addEncodedLane(*one);
  house.add("Door", door);
  house.start();
  lodge.add("Keeper", keeper);
  lodge.start();
  lodge.connect("Keeper/Latch", "house:Door/Latch", {.lane = GetParam(), .laneRequired = true});
  for (int times = 1; times <= 3; ++times) {
    ASSERT_TRUE(keeper.latch.close.start().within(suture::kPatience));
    EXPECT_TRUE(suture::eventually([&] {
      keeper.processEvents();
      return keeper.heard == times;
    }));
  }
  lodge.stop();
  house.stop();
}

}  // namespace
}  // namespace latches
