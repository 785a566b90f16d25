// A provider that writes down what it executes: history_provider <manager address> <process name>
// <log> <its number>. The events that it emits are numbered. Ends on SIGTERM.

#include <suture/base/errors.h>
#include <suture/component/periodic_task.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "fault/history.h"
#include "reference/arm_like.suture.h"

namespace {

using namespace std::chrono_literals;
using reference::JointState;
using reference::Mode;
using reference::PoseStamped;
using suture::HistoryEntry;

class Arm final : public suture::PeriodicTask, public reference::ArmLike {
 public:
  Arm(const std::string& log, double number)
      : PeriodicTask({.period = 2ms}), log_(log), number_(number) {}

  void servo_cp(const PoseStamped& goal) override { executed(goal, 500ms); }
  bool move(const PoseStamped& goal, double speed, const std::string&) override {
    executed(goal, 0ms);
    std::this_thread::sleep_for(std::chrono::duration<double>(speed));
    return true;
  }
  void servo_jp(const JointState&) override {}
  void hold() override {}
  void set_mode(Mode) override {}
  PoseStamped measured_cp() const override { return {}; }
  const JointState& measured_js() const override { return joints_; }
  double distance(const PoseStamped&) const override { return 0; }
  std::uint32_t reset() override { return 0; }
  void limit(double, Mode) override {}

 private:
  void executed(const PoseStamped& goal, suture::Duration ttl) {
    const auto& tag = goal.pose.translation();
    log_.write({.kind = HistoryEntry::Kind::Executed,
                .at = suture::now(),
                .client = static_cast<std::uint32_t>(tag.x()),
                .id = static_cast<std::uint64_t>(tag.y()),
                .epoch = static_cast<std::uint64_t>(tag.z()),
                .limit = ttl});
  }
  void run() override {
    PoseStamped tag;
    tag.pose.translation() << number_, ++events_, 0;
    tag.valid = true;
    arm_.emit().arrived(tag);
  }

  suture::HistoryLog log_;
  const double number_;
  double events_ = 0;
  JointState joints_;
  suture::Provided<reference::ArmLike> arm_{*this, "Arm", *this};
};

}  // namespace

int main(int, char** argv) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    Arm arm(argv[3], std::atof(argv[4]));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("PSM", arm);
    manager.start();
    std::puts("ready");
    std::fflush(stdout);
    int received = 0;
    sigwait(&signals, &received);
    manager.stop();
  } catch (const suture::SetupError& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
  return 0;
}
