// A provider that writes down what it executes: history_provider <manager address> <process name>
// <log> <its number>. The events that it emits are numbered. Ends on SIGTERM.

#include <suture/component/periodic_task.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "fault/history.h"
#include "reference/still_arm.h"
#include "support/hosted_process.h"

namespace {

using namespace std::chrono_literals;
using reference::PoseStamped;
using suture::HistoryEntry;

class Arm final : public suture::PeriodicTask, public suture::StillArm {
 public:
  Arm(const std::string& log, double number)
      : PeriodicTask({.period = 2ms}), log_(log), number_(number) {}

  void servo_cp(const PoseStamped& goal) override { executed(goal, 500ms); }
  bool move(const PoseStamped& goal, double speed, const std::string&) override {
    executed(goal, 0ms);
    std::this_thread::sleep_for(std::chrono::duration<double>(speed));
    return true;
  }

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
  suture::Provided<reference::ArmLike> arm_{*this, "Arm", *this};
};

}  // namespace

int main(int, char** argv) {
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    Arm arm(argv[3], std::atof(argv[4]));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("PSM", arm);
    manager.start();
    process.awaitEnd();
    manager.stop();
  });
}
