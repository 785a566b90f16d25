// Values of any declared size pass through threads with small stacks, and are copied without an
// allocation once there is memory for them.

#include <capnp/ez-rpc.h>
#include <gtest/gtest.h>
#include <kj/async-io.h>
#include <pthread.h>
#include <suture/base/slots/scratch.h>
#include <suture/component/channel/call_limit.h>
#include <suture/component/read_together.h>
#include <suture/component/task/callback_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/peer.capnp.h>
#include <suture/rt/state/state_table.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include "support/allocations.h"
#include "support/eventually.h"
#include "support/process_address.h"
#include "support/temporary_directory.h"
#include "unit/large_values/museum.h"
#include "unit/large_values/picture.capnp.h"

namespace large_values {
namespace {

using namespace std::chrono_literals;
using suture::eventually;

constexpr std::size_t kStack = 64 << 10;

/// Runs `work` in a thread with a stack of kStack.
void withSmallStack(const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_t thread;
  const auto run = [](void* body) -> void* {
    (*static_cast<const std::function<void()>*>(body))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, const_cast<std::function<void()>*>(&work)),
            0);
  pthread_attr_destroy(&attributes);
  pthread_join(thread, nullptr);
}

/// Holds a visitor of a device and one of a task, both in this process.
class LargeValues : public testing::Test {
 protected:
  LargeValues() {
    manager_.add("Device", device_);
    manager_.add("Task", task_);
    manager_.add("OfDevice", ofDevice_);
    manager_.add("OfTask", ofTask_);
    manager_.connect("OfDevice/Gallery", "Device/Gallery");
    manager_.connect("OfTask/Gallery", "Task/Gallery");
    manager_.start();
  }
  ~LargeValues() override { manager_.stop(); }

  WallDevice device_;
  WallTask task_;
  Visitor ofDevice_, ofTask_;
  suture::Manager manager_{"museum"};
};

TEST_F(LargeValues, AreReadOnASmallStack) {
  for (Visitor* const visitor : {&ofDevice_, &ofTask_}) {
    withSmallStack([&] {
      Picture picture;
      EXPECT_TRUE(eventually([&] { return visitor->gallery.newest(picture).hasValue(); }));
      EXPECT_EQ(picture.pixels, grey(9).pixels);
      EXPECT_TRUE(eventually([&] {
        const auto both = readTogether(visitor->gallery.newest, visitor->gallery.oldest);
        return both && std::get<1>(*both).pixels == grey(3).pixels;
      }));
      EXPECT_TRUE(visitor->gallery.newest.at(suture::now() + 1h).hasValue());
    });
  }
}

TEST_F(LargeValues, AreSentOnASmallStack) {
  for (Visitor* const visitor : {&ofDevice_, &ofTask_}) {
    withSmallStack([&] {
      EXPECT_TRUE(visitor->gallery.hang.start(grey(5)).within(suture::kPatience).has_value());
      const auto answer = visitor->gallery.dimmed.start(grey(8)).within(suture::kPatience);
      ASSERT_TRUE(answer.has_value());
      EXPECT_EQ(answer->pixels, grey(4).pixels);
      EXPECT_TRUE(eventually([&] {
        const auto picture = visitor->gallery.newest();
        return picture && picture->pixels == grey(5).pixels;
      }));
    });
  }
}

TEST_F(LargeValues, AreEmittedOnASmallStack) {
  withSmallStack([&] { EXPECT_TRUE(device_.gallery.emit().hung(grey(7)).has_value()); });
  EXPECT_TRUE(eventually([&] {
    ofDevice_.processEvents();
    return ofDevice_.heard == 7;
  }));
}

// Each end of a connection has a table of the rows, and making it touches its memory: a process
// that made one of 64 pairs of images gave no answers for seconds.
TEST_F(LargeValues, AreKeptInFewRows) { EXPECT_EQ(task_.gallery.state()->capacity(), 4u); }

TEST_F(LargeValues, AreAnsweredToFewCallsTogether) {
  auto& newest = ofTask_.gallery.newest;
  const unsigned limit = suture::callLimitOf(suture::interfaceInfo<Gallery>()).calls;
  EXPECT_EQ(limit, 2u);
  {
    std::vector<decltype(newest.fresh())> calls;
    for (unsigned i = 0; i < limit; ++i) {
      calls.push_back(newest.fresh());
      const auto* const answer = calls.back().poll();
      EXPECT_TRUE(answer == nullptr || answer->hasValue()) << "call " << i;
    }
    auto further = newest.fresh();
    ASSERT_NE(further.poll(), nullptr);
    EXPECT_EQ(further.poll()->error(), suture::Errc::TooManyCalls);
  }
  EXPECT_TRUE(eventually([&] { return newest.fresh().within(suture::kPatience).hasValue(); }))
      << "their places are free again";
}

/// Gives no answers before it is opened.
struct ClosedWall final : WallTask {
  ~ClosedWall() override {
    letIn();
    stop();
  }
  void letIn() {
    open = true;
    open.notify_all();
  }
  Picture dimmed(const Picture& picture) const override {
    open.wait(false);
    return WallTask::dimmed(picture);
  }
  std::atomic<bool> open = false;
};

/// A plain Cap'n Proto client sends as many as it likes. Calls for whose answers there is no memory
/// are refused, and each gets an answer.
TEST(LargeAnswers, APlainClientsCallsAreBounded) {
  constexpr unsigned kCalls = 16;
  const unsigned limit = suture::callLimitOf(suture::interfaceInfo<Gallery>()).calls;
  const suture::TemporaryDirectory directory;
  ClosedWall wall;
  suture::loop::ControlThread control;
  const suture::GlobalManager names{control, "unix:" + directory.file("m.sock")};
  suture::Manager manager("museum", names.address());
  manager.add("Wall", wall);
  manager.start();
  capnp::EzRpcClient client(suture::addressOf(names.address(), "museum").c_str());
  auto& scope = client.getWaitScope();
  auto open = client.getMain<suture::wire::Peer>().openRequest();
  open.setComponent("Wall");
  open.setInterface("Gallery");
  auto gallery = open.send().wait(scope).getContract().castAs<wire::Gallery>();
  const auto soon = [&] {
    return client.getIoProvider().getTimer().afterDelay(20 * kj::SECONDS).then([]() -> bool {
      KJ_FAIL_REQUIRE("a call is left without an answer");
    });
  };
  const auto dim = [&] {
    auto request = gallery.dimmedRequest();
    const std::vector<std::uint8_t> pixels(kPixels, 8);
    request.initPicture().setPixels({pixels.data(), pixels.size()});
    return request.send().then([](auto&&) { return true; }, [](kj::Exception&&) { return false; });
  };
  unsigned refused = 0, answered = 0;
  auto allRefused = kj::newPromiseAndFulfiller<bool>();
  std::vector<kj::Promise<bool>> calls;
  for (unsigned i = 0; i < kCalls; ++i) {
    calls.push_back(dim()
                        .then([&](bool good) {
                          if (!good && ++refused == kCalls - limit)
                            allRefused.fulfiller->fulfill(true);
                          return good;
                        })
                        .eagerlyEvaluate(nullptr));
  }
  EXPECT_TRUE(allRefused.promise.exclusiveJoin(soon()).wait(scope));
  wall.letIn();
  for (auto& call : calls) answered += call.exclusiveJoin(soon()).wait(scope) ? 1 : 0;
  EXPECT_EQ(answered, limit);
  EXPECT_TRUE(dim().exclusiveJoin(soon()).wait(scope)) << "its places are not free again";
  manager.stop();
}

TEST_F(LargeValues, ATaskEmitsThemWithoutAllocation) {
  if (!suture::countsAllocations()) GTEST_SKIP() << "a sanitizer needs malloc for itself";
  EXPECT_TRUE(eventually([&] { return task_.emittedOnce.load(std::memory_order_acquire); }));
  EXPECT_EQ(task_.firstEmission, 0u);
}

/// Its thread is the one that triggers it, and is known at the first cycle.
TEST(LargeValuesOfACallbackTask, TheCycleEmitsThemWithoutAllocation) {
  if (!suture::countsAllocations()) GTEST_SKIP() << "a sanitizer needs malloc for itself";
  struct Driven final : suture::CallbackTask, Wall {
    ~Driven() override { stop(); }
    void run() override {
      const auto before = suture::allocations();
      EXPECT_TRUE(gallery.emit().hung(oldest_).has_value());
      taken = suture::allocations() - before;
    }
    std::optional<std::uint64_t> taken;
    suture::Provided<Gallery> gallery{*this, "Gallery", *this};
  } driven;
  suture::Manager manager{"museum"};
  manager.add("Driven", driven);
  manager.start();
  std::thread driver([&] { EXPECT_TRUE(driven.trigger()); });
  driver.join();
  EXPECT_EQ(driven.taken, 0u);
  manager.stop();
}

TEST_F(LargeValues, ReadingAllocatesOnlyAtFirst) {
  if (!suture::countsAllocations()) GTEST_SKIP() << "a sanitizer needs malloc for itself";
  Picture picture;
  ASSERT_TRUE(eventually([&] { return ofTask_.gallery.newest(picture).hasValue(); }));
  const auto before = suture::allocations();
  EXPECT_TRUE(ofTask_.gallery.newest(picture).hasValue());
  EXPECT_EQ(suture::allocations(), before);
}

/// A small value that is handled first must not take the block that the large one within needs.
TEST(ScratchMemory, IsTheSmallestSufficientBlock) {
  if (!suture::countsAllocations()) GTEST_SKIP() << "a sanitizer needs malloc for itself";
  std::uint64_t taken = 1;
  std::thread thread([&] {
    const auto both = [](std::size_t outer, std::size_t inner) {
      const suture::ScratchMemory one(outer), other(inner);
    };
    both(2 << 20, 20 << 10);
    const auto before = suture::allocations();
    both(20 << 10, 2 << 20);
    both(2 << 20, 20 << 10);
    taken = suture::allocations() - before;
  });
  thread.join();
  EXPECT_EQ(taken, 0u);
}

}  // namespace
}  // namespace large_values
