// What becomes of connections that might share memory.
#include <gtest/gtest.h>
#include <suture/component/channel.h>
#include <suture/component/periodic_task.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/transport/rpc/control_thread.h>

#include <filesystem>
#include <limits>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::PoseStamped;

struct Psm final : PeriodicTask, StillArm {
  Psm() : PeriodicTask({.period = 1ms}) {}
  ~Psm() override { stop(); }
  void run() override {}
  bool move(const PoseStamped&, double, const std::string&) override { return true; }
  Provided<ArmLike> port{*this, "Arm", *this};
};

struct Teleop final : PeriodicTask {
  Teleop() : PeriodicTask({.period = 1ms}) {}
  ~Teleop() override { stop(); }
  void run() override {
    if (asked.exchange(false)) {
      call = slave.move.start({}, speed, "test");
      waiting = true;
    }
    if (waiting && call.poll() != nullptr) {
      waiting = false;
      outcome = call.poll()->has_value() ? Errc{} : call.poll()->error();
    }
    reachable = slave.connected();
  }
  std::atomic<bool> asked{false}, reachable{false};
  std::atomic<double> speed{0};
  bool waiting = false;
  std::atomic<Errc> outcome{Errc::NotYet};
  Required<ArmLike> slave{*this, "Slave"};
  decltype(std::declval<Required<ArmLike>&>().move.start({}, 0, "")) call{Errc::NotYet};
};

std::size_t openDescriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

class SharedConnections : public testing::Test {
 protected:
  void begin(const std::string& address) {
    global_ = std::make_unique<GlobalManager>(control_, address);
    robot = std::make_unique<Manager>("robot", global_->address());
    console = std::make_unique<Manager>("console", global_->address());
    robot->add("PSM", psm);
    console->add("Teleop", teleop);
    robot->start();
    console->start();
  }
  std::string unixAddress() const { return "unix:" + directory_.file("manager.sock"); }
  void connect(Lane lane = Lane::Auto) {
    console->connect("Teleop/Slave", "robot:PSM/Arm", lane);
    ASSERT_TRUE(eventually([&] { return teleop.reachable.load(); }));
  }
  std::shared_ptr<Channel> channel() const { return console->channels().at(0); }
  Errc outcomeOf(double speed) {
    teleop.outcome = Errc::NotYet;
    teleop.speed = speed;
    teleop.asked = true;
    EXPECT_TRUE(eventually([&] { return teleop.outcome != Errc::NotYet; }));
    return teleop.outcome;
  }

  Psm psm;
  Teleop teleop;
  std::unique_ptr<Manager> robot, console;

 private:
  TemporaryDirectory directory_;
  rpc::ControlThread control_;
  std::unique_ptr<GlobalManager> global_;
};

TEST_F(SharedConnections, OnOneMachineAreTheFastest) {
  begin(unixAddress());
  connect();
  EXPECT_EQ(channel()->lane, "shm");
  EXPECT_EQ(channel()->laneReason, "");
}

TEST_F(SharedConnections, CanBeDoneWithout) {
  begin(unixAddress());
  connect(Lane::Rpc);
  EXPECT_EQ(channel()->lane, "rpc");
  EXPECT_EQ(channel()->laneReason, "");
}

TEST_F(SharedConnections, OverTcpFallBackToFramesAndSayWhy) {
  begin("tcp://127.0.0.1:0");
  connect(Lane::Shm);
  EXPECT_EQ(channel()->lane, "frame");
  EXPECT_EQ(channel()->laneReason, "the two processes are not reached by a Unix socket");
}

TEST_F(SharedConnections, RefuseWhatIsOutOfRangeAndNoNumber) {
  begin(unixAddress());
  connect(Lane::Shm);
  EXPECT_EQ(outcomeOf(0.5), Errc{});
  EXPECT_EQ(outcomeOf(1.5), Errc::Invalid);
  EXPECT_EQ(outcomeOf(std::numeric_limits<double>::quiet_NaN()), Errc::Invalid);
  EXPECT_EQ(outcomeOf(1), Errc{});
}

TEST_F(SharedConnections, GiveEverythingBack) {
  begin(unixAddress());
  connect();
  console->disconnect("Teleop/Slave");
  ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
  std::size_t before = 0;
  for (int lap = 0; lap < 50; ++lap) {
    connect();
    EXPECT_EQ(channel()->lane, "shm");
    console->disconnect("Teleop/Slave");
    ASSERT_TRUE(eventually([&] { return !teleop.reachable; }));
    if (lap == 4) before = openDescriptors();
  }
  EXPECT_TRUE(eventually([&] { return openDescriptors() <= before + 3; })) << openDescriptors();
}

}  // namespace
}  // namespace suture
