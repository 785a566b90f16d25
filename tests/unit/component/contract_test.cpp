// These tests say what a connection's contract makes of values that are too old, and of a provider
// that is lost.

#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/read_together.h>
#include <suture/wiring/connect.h>

#include <functional>
#include <stdexcept>

#include "unit/component/driven_arm.h"

namespace suture {
namespace {

using namespace std::chrono_literals;

struct Reader final : Task {
  void start() override {
    prepare();
    enter();
  }
  void stop() override { leave(); }
  using Task::cycle;

  Required<reference::ArmLike> slave{*this, "Slave"};
  std::function<void()> work = [] {};

 private:
  void run() override { work(); }
};

/// Holds a reader and two arms, all driven by the test.
class Contract : public testing::Test {
 protected:
  Contract() {
    arm_.configure();
    arm_.start();
    spare_.configure();
    spare_.start();
    reader_.start();
  }

  void connect(const ConnectionContract& contract) {
    watch_ = std::make_shared<ConnectionWatch>(contract);
    connectTo(arm_);
    EXPECT_EQ(reader_.slave.measured_cp().error(), Errc::NotYet);
    arm_.cycle();
  }
  void connectTo(DrivenArm& arm) {
    connectLocally(reader_.slave, arm.automaticPort, "Reader/Slave -> PSM/Arm", watch_);
    reader_.cycle();
  }
  Sample<reference::PoseStamped> read() { return reader_.slave.measured_cp(); }
  static double x(const Sample<reference::PoseStamped>& pose) {
    return pose->pose.translation().x();
  }
  Errc hold() {
    const auto answer = reader_.slave.hold();
    return answer ? Errc{} : answer.error();
  }
  bool faulted() const { return reader_.state() == ComponentState::Faulted; }

  DrivenArm arm_, spare_;
  Reader reader_;
  std::shared_ptr<ConnectionWatch> watch_;
};

// No value is as young as the first of these, and every value is younger than the other.
constexpr Duration kNothing = 1ns, kAnything = 24h;

TEST_F(Contract, AYoungValueIsUnchanged) {
  connect({.maxAge = kAnything});
  EXPECT_TRUE(read());
  EXPECT_EQ(read().error(), Errc{});
  EXPECT_EQ(watch_->staleReads, 0u);
}

TEST_F(Contract, HoldDoesNotOfferAStaleValue) {
  connect({.maxAge = kNothing, .onStale = Fallback::Hold});
  const auto pose = read();
  EXPECT_FALSE(pose);
  EXPECT_EQ(pose.error(), Errc::Stale);
  ASSERT_TRUE(pose.carriesValue());
  EXPECT_EQ(x(pose), 1);
  EXPECT_GT(pose.age(), kNothing);
  EXPECT_EQ(watch_->staleReads, 1u);
  EXPECT_FALSE(faulted());
}

TEST_F(Contract, LastOffersTheStaleValue) {
  connect({.maxAge = kNothing, .onStale = Fallback::Last});
  const auto pose = read();
  EXPECT_TRUE(pose);
  EXPECT_EQ(pose.error(), Errc::Stale);
  EXPECT_EQ(x(pose), 1);
}

TEST_F(Contract, ZeroOffersAValueOfItsOwn) {
  connect({.maxAge = kNothing, .onStale = Fallback::Zero});
  const auto pose = read();
  EXPECT_TRUE(pose);
  EXPECT_EQ(pose.error(), Errc::Stale);
  EXPECT_TRUE(pose->pose.affine().isZero(0)) << "whatever a value holds that nobody has set";
}

TEST_F(Contract, FaultParksTheReader) {
  connect({.maxAge = kNothing, .onStale = Fallback::Fault});
  EXPECT_FALSE(read());
  EXPECT_TRUE(faulted());
  EXPECT_NE(reader_.fault().find("Reader/Slave -> PSM/Arm"), std::string::npos);
  EXPECT_NE(reader_.fault().find("on_stale is fault"), std::string::npos);
  EXPECT_EQ(reader_.faultCause(), FaultCause::Connection);
  EXPECT_EQ(reader_.whyFaulted(), reader_.fault());
}

TEST_F(Contract, HoldsForSeveralReadsOfOneRow) {
  connect({.maxAge = kNothing, .onStale = Fallback::Zero});
  const auto row = readTogether(reader_.slave.measured_cp);
  EXPECT_TRUE(row);
  EXPECT_EQ(row.error(), Errc::Stale);
  EXPECT_TRUE(std::get<0>(*row).pose.affine().isZero(0));
}

TEST_F(Contract, ALossFailsCommandsAndDefaultsReads) {
  connect({.maxAge = kAnything, .onLoss = Fallback::Last});
  arm_.stop();
  EXPECT_EQ(hold(), Errc::Lost);
  const auto pose = read();
  EXPECT_TRUE(pose);
  EXPECT_EQ(pose.error(), Errc::Lost);
  EXPECT_EQ(x(pose), 1);
  reader_.cycle();
  EXPECT_EQ(watch_->losses, 1u);
}

TEST_F(Contract, ALossDefaultsReadsOfOneRow) {
  connect({.onLoss = Fallback::Zero});
  arm_.stop();
  const auto row = readTogether(reader_.slave.measured_cp);
  EXPECT_TRUE(row);
  EXPECT_EQ(row.error(), Errc::Lost);
  EXPECT_TRUE(std::get<0>(*row).pose.affine().isZero(0));
  const auto before = readTogetherAt(now(), reader_.slave.measured_cp);
  EXPECT_FALSE(before) << "a read of a time is not judged";
  EXPECT_EQ(before.error(), Errc::Lost);
}

TEST_F(Contract, AReadWithoutContractTellsTheLoss) {
  connectTo(arm_);
  EXPECT_EQ(read().error(), Errc::NotYet);
  arm_.cycle();
  EXPECT_TRUE(read());
  arm_.stop();
  EXPECT_EQ(read().error(), Errc::Lost);
  EXPECT_FALSE(read().carriesValue());
  EXPECT_FALSE(readTogether(reader_.slave.measured_cp).carriesValue());
}

TEST_F(Contract, ALossMayParkAnIdleReader) {
  connect({.onLoss = Fallback::Fault});
  int runs = 0;
  reader_.work = [&] { ++runs; };
  arm_.stop();
  reader_.cycle();
  EXPECT_TRUE(faulted());
  EXPECT_EQ(runs, 0) << "what must not go on went on";
  EXPECT_EQ(reader_.faultCause(), FaultCause::Connection);
}

TEST_F(Contract, AStoppedFaultedProviderIsLost) {
  connect({});
  arm_.work = [] { throw std::runtime_error("the drive did not answer"); };
  arm_.cycle();
  EXPECT_EQ(hold(), Errc::Faulted);
  arm_.stop();
  EXPECT_EQ(hold(), Errc::Lost);
}

TEST_F(Contract, ARestartAwaitsWhatWasLost) {
  connect({.onLoss = Fallback::Fault});
  reader_.restartAfterFaults({.most = 3, .per = 24h});
  int runs = 0;
  reader_.work = [&] { ++runs; };
  arm_.stop();
  for (int i = 0; i < 5; ++i) reader_.cycle();
  EXPECT_TRUE(faulted()) << "it runs without what it requires";
  EXPECT_FALSE(reader_.staysFaulted());
  EXPECT_EQ(runs, 0);
  connectTo(spare_);
  EXPECT_FALSE(faulted());
  reader_.cycle();
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(reader_.faults(), 1u) << "waiting takes nothing from the budget";
}

TEST_F(Contract, ASuspensionOutlivesARestart) {
  connect({.onLoss = Fallback::Fault});
  reader_.restartAfterFaults({.most = 3, .per = 24h});
  reader_.request(Transition::Suspend);
  arm_.stop();
  for (int i = 0; i < 3; ++i) reader_.cycle();
  EXPECT_TRUE(faulted());
  connectTo(spare_);
  EXPECT_EQ(reader_.state(), ComponentState::Suspended);
}

TEST_F(Contract, AfterALossCommandsAwaitTheOperator) {
  connect({.resume = Resume::Operator});
  EXPECT_EQ(hold(), Errc{});
  arm_.stop();
  connectTo(spare_);  // made anew before the reader looked
  EXPECT_EQ(hold(), Errc::AwaitingOperator);
  EXPECT_EQ(reader_.slave.set_mode.start(reference::Mode::Enabled).within(0s).error(),
            Errc::AwaitingOperator);
  EXPECT_EQ(read().error(), Errc::NotYet) << "a read moves nothing";
  watch_->awaitsOperator = false;
  EXPECT_EQ(hold(), Errc{});
}

TEST_F(Contract, CommandsAfterARestartAwaitTheOperator) {
  arm_.restartAfterFaults({.most = 1, .per = 24h});
  connect({.resume = Resume::Operator});
  arm_.work = [] { throw std::runtime_error("the drive did not answer"); };
  arm_.cycle();
  EXPECT_EQ(arm_.state(), ComponentState::Running);
  EXPECT_EQ(hold(), Errc::AwaitingOperator);
  EXPECT_TRUE(read()) << "a read moves nothing";
  EXPECT_EQ(reader_.slave.resume(), ResumeOutcome::ProviderLost) << "nobody has seen that loss";
  EXPECT_EQ(hold(), Errc::AwaitingOperator);
  EXPECT_EQ(reader_.slave.resume(), ResumeOutcome::Resumed);
  EXPECT_EQ(hold(), Errc{});
}

TEST_F(Contract, CommandsOtherwiseResumeAfterALoss) {
  connect({.maxAge = kAnything});
  arm_.stop();
  connectTo(spare_);
  EXPECT_EQ(hold(), Errc{});
}

TEST_F(Contract, AStaleReadAwaitsTheOperatorToo) {
  connect({.maxAge = kNothing, .resume = Resume::Operator});
  EXPECT_EQ(hold(), Errc{});
  EXPECT_FALSE(read());
  EXPECT_EQ(hold(), Errc::AwaitingOperator);
}

TEST_F(Contract, AnotherConnectionBeginsAnew) {
  connect({.resume = Resume::Operator});
  arm_.stop();
  reader_.cycle();
  watch_ = std::make_shared<ConnectionWatch>(watch_->contract);
  connectTo(spare_);
  EXPECT_EQ(hold(), Errc{});
}

TEST_F(Contract, ItsDeadlineIsThatOfCalls) {
  connect({.deadline = 1ns});
  auto call = reader_.slave.reset.start();
  const Time begin = now();
  EXPECT_EQ(call.within().error(), Errc::Timeout);
  EXPECT_LT(now() - begin, kDefaultDeadline);
}

}  // namespace
}  // namespace suture
