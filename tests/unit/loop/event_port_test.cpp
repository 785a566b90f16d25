#include <gtest/gtest.h>
#include <suture/loop/event_port.h>
#include <unistd.h>

#include <functional>
#include <vector>

namespace suture::loop {
namespace {

/// This is a port whose other threads functions play.
class Port final : public EventPort {
 public:
  using EventPort::EventPort;
  std::function<void()> work = [] {};

 private:
  void takeWork() override { work(); }
};

struct CountedOutput final : EventPort::Output {
  void flush() override { ++flushes; }
  unsigned flushes = 0;
};

/// Runs an event that arms itself again and again.
kj::Promise<void> turns(unsigned count) {
  if (count == 0) return kj::READY_NOW;
  return kj::evalLater([count] { return turns(count - 1); });
}

TEST(EventPort, FlushesOnceWhenIdle) {
  Port port;
  CountedOutput output;
  auto writes = turns(10).then([&] {
    port.flushBeforeSleep(output);
    port.flushBeforeSleep(output);
    EXPECT_EQ(output.flushes, 0u);
  });
  writes.wait(port.scope());
  port.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port.scope());
  EXPECT_EQ(output.flushes, 1u);
}

TEST(EventPort, FlushesInTheOrderAsked) {
  struct Noted final : EventPort::Output {
    explicit Noted(std::vector<Noted*>& all) : order(all) {}
    void flush() override { order.push_back(this); }
    std::vector<Noted*>& order;
  };
  Port port;
  std::vector<Noted*> order;
  Noted first(order), second(order);
  port.flushBeforeSleep(first);
  port.flushBeforeSleep(second);
  port.scope().poll();
  EXPECT_EQ(order, (std::vector<Noted*>{&first, &second}));
}

TEST(EventPort, FlushesAfterOthersWork) {
  Port port;
  CountedOutput output;
  auto gate = kj::newPromiseAndFulfiller<void>();
  bool handedOver = false;
  port.work = [&] {
    if (std::exchange(handedOver, true)) return;
    EXPECT_EQ(output.flushes, 0u);
    gate.fulfiller->fulfill();
  };
  port.flushBeforeSleep(output);
  gate.promise.then([&] { EXPECT_EQ(output.flushes, 0u); }).wait(port.scope());
}

// The rings alone end the wait: a port that sleeps over one is woken by the timer only.
TEST(EventPort, DoesNotSleepOverARing) {
  rt::Doorbell bell;
  Port port(&bell);
  auto rung = kj::newPromiseAndFulfiller<void>();
  unsigned asked = 0;
  port.work = [&] {
    bell.ring();
    if (++asked == 50) rung.fulfiller->fulfill();
  };
  rung.promise.exclusiveJoin(port.getTimer().afterDelay(10 * kj::SECONDS)).wait(port.scope());
  EXPECT_GE(asked, 50u);
}

// This work has no end, since each turn finds more. Output and a socket must not wait for its end.
TEST(EventPort, EndlessWorkStarvesNoOther) {
  Port port;
  CountedOutput output;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  kj::AutoCloseFd reading(ends[0]), writing(ends[1]);
  EventPort::FdObserver observer(port, reading, EventPort::FdObserver::OBSERVE_READ);
  kj::Promise<void> endless = kj::READY_NOW;
  unsigned handedOver = 0;
  port.work = [&] {
    ASSERT_LT(++handedOver, 1000u) << "the socket is never looked at";
    endless = kj::evalLater([] {}).eagerlyEvaluate(nullptr);
  };
  port.flushBeforeSleep(output);
  ASSERT_EQ(write(writing, "x", 1), 1);
  observer.whenBecomesReadable().wait(port.scope());
  EXPECT_EQ(output.flushes, 1u);
}

TEST(EventPort, AnOutputThatEndsIsForgotten) {
  Port port;
  CountedOutput output;
  port.flushBeforeSleep(output);
  port.forget(output);
  port.getTimer().afterDelay(1 * kj::MILLISECONDS).wait(port.scope());
  EXPECT_EQ(output.flushes, 0u);
}

}  // namespace
}  // namespace suture::loop
