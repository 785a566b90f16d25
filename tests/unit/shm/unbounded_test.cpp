// A client of a contract with bounds is served by one that derives from it and has none.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <string>

#include "support/contains.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"
#include "unit/shm/logbook.suture.h"

namespace logs {
namespace {

struct Desk final : suture::Device, Logbook {
  void count(int entries) override { entries_ += entries; }
  int entries() const override { return entries_; }
  const std::string& text() const override { return text_; }

  suture::Provided<Logbook> book{*this, "Book", *this};

 private:
  int entries_ = 0;
  std::string text_;
};

struct Clerk final : suture::Device {
  suture::Required<Counter> counter{*this, "Counter"};
};

/// Two managers in one process are two processes to each other.
class UnboundedRows : public testing::Test {
 protected:
  UnboundedRows() {
    office_.add("Desk", desk_);
    home_.add("Clerk", clerk_);
    office_.start();
    home_.start();
  }
  ~UnboundedRows() override {
    home_.stop();
    office_.stop();
  }
  std::string refusalOf(const suture::ConnectOptions& options) {
    return suture::refusal([&] { home_.connect("Clerk/Counter", "office:Desk/Book", options); });
  }

  const suture::TemporaryDirectory directory_;
  Desk desk_;
  Clerk clerk_;
  suture::loop::ControlThread control_;
  const suture::GlobalManager names_{control_, "unix:" + directory_.file("m.sock")};
  suture::Manager office_{"office", names_.address()}, home_{"home", names_.address()};
};

constexpr const char* kReason = "the provider's rows have values without a bound";

TEST_F(UnboundedRows, TravelByFramesWithoutTheirUnboundedColumns) {
  ASSERT_EQ(refusalOf({}), "");
  const auto channel = home_.channels().at(0);
  EXPECT_EQ(channel->lane, "frame");
  EXPECT_EQ(channel->terms.laneReason, kReason);
  ASSERT_TRUE(clerk_.counter.count.start(3).within(suture::kPatience));
  EXPECT_TRUE(suture::eventually([&] {
    const auto entries = clerk_.counter.entries();
    return entries && *entries == 3;
  }));
}

TEST_F(UnboundedRows, RequiringSharedMemoryCrashesNothing) {
  EXPECT_TRUE(
      suture::contains(refusalOf({.lane = suture::Lane::Shm, .laneRequired = true}),
                       "lane 'shm' is required and cannot carry it: " + std::string(kReason)));
  EXPECT_EQ(refusalOf({}), "") << "the provider's process is gone";
}

}  // namespace
}  // namespace logs
