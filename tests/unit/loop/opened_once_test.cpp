// These tests see that something slow to open is opened once for all who ask for it.

#include <gtest/gtest.h>
#include <suture/loop/event_port.h>
#include <suture/loop/failure.h>
#include <suture/loop/opened_once.h>

namespace suture::loop {
namespace {

struct Thing {
  bool broken() const { return isBroken; }
  bool isBroken = false;
};
using Opened = std::shared_ptr<Thing>;

class OpenedOnceTest : public testing::Test {
 public:
  ~OpenedOnceTest() noexcept override {}

 protected:
  /// Asks; the thing comes when the opening is let through.
  kj::Promise<Opened> ask() {
    return once_.get([this]() -> kj::Promise<Opened> {
      ++openings_;
      auto pair = kj::newPromiseAndFulfiller<Opened>();
      let_ = kj::mv(pair.fulfiller);
      return kj::mv(pair.promise);
    });
  }

  EventPort port_;
  OpenedOnce<Thing> once_;
  kj::Own<kj::PromiseFulfiller<Opened>> let_;
  int openings_ = 0;
};

TEST_F(OpenedOnceTest, AllAskersGetTheSame) {
  auto first = ask(), second = ask();
  EXPECT_FALSE(first.poll(port_.scope()));
  let_->fulfill(std::make_shared<Thing>());
  const Opened thing = first.wait(port_.scope());
  EXPECT_EQ(second.wait(port_.scope()), thing);
  EXPECT_EQ(ask().wait(port_.scope()), thing);
  EXPECT_EQ(openings_, 1);
}

TEST_F(OpenedOnceTest, AnAskersEndHurtsNoOthers) {
  auto second = [this] {
    auto first = ask();
    return ask();
  }();
  let_->fulfill(std::make_shared<Thing>());
  EXPECT_NE(second.wait(port_.scope()), nullptr);
}

TEST_F(OpenedOnceTest, AFailureIsSharedAndTriedAgain) {
  auto first = ask(), second = ask();
  let_->reject(failure(kj::Exception::Type::FAILED, "no such thing"));
  EXPECT_THROW(first.wait(port_.scope()), kj::Exception);
  EXPECT_THROW(second.wait(port_.scope()), kj::Exception);
  auto third = ask();
  let_->fulfill(std::make_shared<Thing>());
  EXPECT_NE(third.wait(port_.scope()), nullptr);
  EXPECT_EQ(openings_, 2);
}

TEST_F(OpenedOnceTest, BrokenOrUnusedOnesAreOpenedAnew) {
  auto first = ask();
  let_->fulfill(std::make_shared<Thing>());
  Opened thing = first.wait(port_.scope());
  thing->isBroken = true;
  auto second = ask();
  let_->fulfill(std::make_shared<Thing>());
  EXPECT_NE(second.wait(port_.scope()), thing);
  thing.reset();
  auto third = ask();
  let_->fulfill(std::make_shared<Thing>());
  third.wait(port_.scope());
  EXPECT_EQ(openings_, 3);
}

}  // namespace
}  // namespace suture::loop
