// Values without bounds travel between devices: they arrive whole, and what is dropped, replaced or
// given up on the way is freed, as AddressSanitizer's leak check tells.

#include "conformance/ends/archive.h"

#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include "support/eventually.h"
#include "support/patience.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;
using suture::Errc;
using suture::eventually;
using suture::kPatience;

class Archives : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    const bool remote = GetParam();
    if (remote) {
      const std::string address = "unix:" + directory_.file("manager.sock");
      control_ = std::make_unique<suture::loop::ControlThread>();
      global_ = std::make_unique<suture::GlobalManager>(*control_, address);
      providerManager_ = std::make_unique<suture::Manager>("provider", address);
      clientManager_ = std::make_unique<suture::Manager>("client", address);
    } else {
      providerManager_ = std::make_unique<suture::Manager>("alone");
    }
    suture::Manager& client = remote ? *clientManager_ : *providerManager_;
    providerManager_->add("Store", device);
    client.add("Reader", reader);
    providerManager_->start();
    if (remote) client.start();
    // Values of many megabytes keep a control thread busy, under a sanitizer for seconds.
    client.connect("Reader/Archive", remote ? "provider:Store/Archive" : "Store/Archive",
                   {.contract = {.silence = 30s}});
    channel = client.channels().at(0);
    EXPECT_EQ(channel->lane, remote ? "rpc" : "local");
  }
  void TearDown() override {
    if (clientManager_) clientManager_->stop();
    providerManager_->stop();
  }

  /// Handles events until `condition` holds; returns false if it does not within kPatience.
  template <class Condition>
  bool await(const Condition& condition) {
    const auto deadline = suture::now() + kPatience;
    reader.processEvents();
    while (!condition() && suture::now() < deadline) reader.waitForEvents(suture::now() + 10ms);
    return condition();
  }

  static shapes::Open sized(std::size_t size) {
    shapes::Open value;
    value.samples.assign(size, 0.5);
    value.series["line"].resize(size / 10);
    return value;
  }

  ArchiveDevice device;
  Reader reader;
  std::shared_ptr<suture::Channel> channel;

 private:
  suture::TemporaryDirectory directory_;
  std::unique_ptr<suture::loop::ControlThread> control_;
  std::unique_ptr<suture::GlobalManager> global_;
  std::unique_ptr<suture::Manager> providerManager_, clientManager_;
};

TEST_P(Archives, WritesArriveWhole) {
  EXPECT_TRUE(reader.archive.put.start("first", sized(100'000)).within(kPatience));
  EXPECT_EQ(device.newest().samples.size(), 100'000u);
  EXPECT_EQ(device.newest().series.at("line").size(), 10'000u);
  EXPECT_EQ(device.newest().name, "first");
}

TEST_P(Archives, AValueWithoutRoomIsFreed) {
  int taken = 0, refused = 0;
  for (int i = 0; i < 200; ++i) {
    reader.archive.put("key", sized(100)) ? ++taken : ++refused;
  }
  EXPECT_GT(taken, 0);
  EXPECT_TRUE(GetParam() || refused == 0);
  EXPECT_TRUE(eventually([&] { return device.puts() == taken; }));
}

TEST_P(Archives, TheLastNewestWinsCommandArrives) {
  for (int i = 0; i <= 1000; ++i) EXPECT_TRUE(reader.archive.remark(std::to_string(i)));
  EXPECT_TRUE(eventually([&] { return device.remark() == "1000"; }));
}

TEST_P(Archives, ReadsFollowTheProvider) {
  for (const std::size_t size : {10u, 1000u, 3u}) {
    EXPECT_TRUE(reader.archive.put.start("read", sized(size)).within(kPatience));
    EXPECT_TRUE(eventually([&] {
      const auto newest = reader.archive.newest();
      return newest && newest->samples.size() == size;
    }));
    auto call = reader.archive.newest.fresh();
    const auto& fresh = call.within(kPatience);
    ASSERT_TRUE(fresh) << suture::toString(fresh.error());
    EXPECT_EQ(fresh->samples.size(), size);
  }
}

TEST_P(Archives, QuestionsAndAnswers) {
  const auto found = reader.archive.find.start("key").within(kPatience);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (std::vector<std::string>{"key 1", "key 2"}));
  auto call = reader.archive.replace.start(sized(5000));
  const auto& replaced = call.within(kPatience);
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->name, " replaced");
  EXPECT_EQ(replaced->samples.size(), 5000u);
}

TEST_P(Archives, AnAbandonedAnswerIsFreed) {
  shapes::Open slow = sized(10);
  slow.name = "slow";
  const bool remote = GetParam();  // otherwise it is executed at once, in this thread
  if (remote) device.gate.close();
  {
    auto given = reader.archive.replace.start(slow);
    EXPECT_TRUE(!remote || eventually([&] { return device.gate.hasVisitor(); }));
  }
  device.gate.open();
  EXPECT_TRUE(reader.archive.replace.start(sized(10)).within(kPatience));
  if (remote) device.gate.close();
  {
    auto late = reader.archive.replace.start(slow);
    EXPECT_EQ(late.within(1ms).has_value(), !remote);
  }
  device.gate.open();
  EXPECT_TRUE(reader.archive.replace.start(sized(10)).within(kPatience));
}

TEST_P(Archives, AThrowFreesWhatWasUnderWay) {
  shapes::Open bad = sized(10);
  bad.name = "throw";
  auto call = reader.archive.replace.start(bad);
  const auto& answer = call.within(kPatience);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error(), Errc::Faulted);
}

TEST_P(Archives, EventsArriveWhole) {
  shapes::Root root;
  root.children.resize(3);
  EXPECT_TRUE(device.emit().grown("oak", root));
  EXPECT_TRUE(device.emit().changed(sized(10)));
  EXPECT_TRUE(device.emit().changed(sized(20)));
  EXPECT_TRUE(await([&] { return reader.changed.size() == 20 && !reader.grown.empty(); }));
  EXPECT_EQ(reader.grown, std::vector<std::string>{"oak 3"});
}

TEST_P(Archives, UntakenEventsAreFreedAndCounted) {
  const int kMany = 1000;
  for (int i = 0; i < kMany; ++i) {
    device.emit().grown("oak", {});
    device.emit().changed(sized(10));
  }
  EXPECT_TRUE(GetParam() || channel->events.dropped() > 0);
  EXPECT_TRUE(await([&] { return reader.changed.size() == 10; }));
  EXPECT_LE(reader.grown.size(), std::size_t{kMany});
}

TEST_P(Archives, TheLastValueAwaitsLateJoiners) {
  device.emit().renamed("one");
  device.emit().renamed("two");
  EXPECT_TRUE(await([&] { return !reader.names.empty() && reader.names.back() == "two"; }));
}

/// Values are sent as messages.
class RemoteArchives : public Archives {};

TEST_P(RemoteArchives, ATooLargeMessageIsRefusedAlone) {
  shapes::Open huge;
  huge.name = std::string(17u << 20, 'x');
  const auto refused = reader.archive.put.start(huge.name, {}).within(kPatience);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), Errc::TooLarge);
  device.put(huge.name, {});
  EXPECT_TRUE(eventually([&] {
    const auto newest = reader.archive.newest();
    return !newest && newest.error() == Errc::TooLarge;
  }));
  EXPECT_TRUE(device.emit().changed(huge));
  EXPECT_TRUE(device.emit().grown("after", {}));
  EXPECT_TRUE(await([&] { return !reader.grown.empty(); }));
  EXPECT_TRUE(reader.archive.put.start("small", sized(3)).within(kPatience));
  EXPECT_TRUE(eventually([&] {
    const auto newest = reader.archive.newest();
    return newest && newest->samples.size() == 3;
  }));
}

std::string laneOf(const testing::TestParamInfo<bool>& remote) {
  return remote.param ? "Rpc" : "Local";
}

INSTANTIATE_TEST_SUITE_P(Lanes, Archives, testing::Values(false, true), laneOf);
INSTANTIATE_TEST_SUITE_P(Lanes, RemoteArchives, testing::Values(true), laneOf);

TEST(Archive, CannotBeDelayed) {
  ArchiveDevice device;
  Reader reader;
  suture::Manager manager("alone");
  manager.add("Store", device);
  manager.add("Reader", reader);
  EXPECT_EQ(suture::refusal([&] {
              manager.connect("Reader/Archive", "Store/Archive", {.delay = {.commands = 1ms}});
            }),
            "a delay on a connection of shapes::Archive: command 'put' has values without a bound. "
            "Give it a capacity()");
}

TEST(Archive, IsNothingForATask) {
  struct Task final : suture::EventTask {
    void run() override {}
    suture::Required<shapes::Archive> archive{*this, "Archive"};
  };
  try {
    Task task;
    FAIL() << "a task requires a contract without bounds";
  } catch (const suture::SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("command 'put' has values without a bound"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace conformance
