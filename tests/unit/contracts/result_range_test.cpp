// No client is given an answer outside the range() that its contract promises.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/task.h>
#include <suture/wiring/connect.h>

#include <limits>

#include "unit/contracts/share.suture.h"

namespace {

using contracts::Share;
using suture::Errc;

/// Answers what the test says.
struct Answers final : Share {
  double share() const override { return answer; }
  std::int32_t shares(bool) const override { return static_cast<std::int32_t>(answer); }
  double take(double) override { return answer; }
  double reach() const override { return reached; }

  double answer = 1;
  double reached = std::numeric_limits<double>::infinity();
};

/// Runs a cycle only when the test calls cycle().
struct Teller final : suture::Task {
  Teller() { start(); }
  ~Teller() override { stop(); }
  void start() override { enter(); }
  void stop() override { leave(); }
  using Task::cycle;

  Answers answers;
  suture::Provided<Share> port{*this, "Share", answers};

 private:
  void run() override {}
};

struct Asker final : suture::Device {
  suture::Required<Share> from{*this, "From"};
};

class ResultRange : public testing::Test {
 protected:
  ResultRange() { suture::connectLocally(asker_.from, teller_.port, "test"); }

  template <class Read>
  Errc errorOf(Read& read) {
    read();  // asks for it from now on
    teller_.cycle();
    return read().error();
  }

  template <class Call>
  Errc answerOf(Call call) {
    teller_.cycle();
    const auto answer = call.poll();
    if (!answer) return Errc::NotYet;
    return *answer ? Errc{} : answer->error();
  }

  Teller teller_;
  Asker asker_;
};

TEST_F(ResultRange, WhatLiesWithinArrives) {
  EXPECT_EQ(errorOf(asker_.from.share), Errc{});
  EXPECT_EQ(answerOf(asker_.from.shares.start(true)), Errc{});
  EXPECT_EQ(answerOf(asker_.from.take.start(1)), Errc{});
}

TEST_F(ResultRange, WhatLiesOutsideIsInvalid) {
  teller_.answers.answer = 2;
  EXPECT_EQ(errorOf(asker_.from.share), Errc::Invalid);
  EXPECT_EQ(answerOf(asker_.from.shares.start(true)), Errc::Invalid);
  EXPECT_EQ(answerOf(asker_.from.take.start(1)), Errc::Invalid);
}

TEST_F(ResultRange, InfinityPassesWhereTheRangeHasIt) {
  EXPECT_EQ(errorOf(asker_.from.reach), Errc{});
  teller_.answers.reached = -1;
  EXPECT_EQ(errorOf(asker_.from.reach), Errc::Invalid);
}

}  // namespace
