// A client that writes down what it sends, how that ends, and what it hears: history_client
// <manager address> <process name> <log> <its number> <robot> busy|idle <longest silence, ms>.
// Says "begun", then "ready" when it is connected to <robot>:PSM/Arm. An idle one only listens.
// Ends on SIGTERM.

#include <suture/component/channel.h>
#include <suture/component/device.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "fault/history.h"
#include "reference/arm_like.suture.h"
#include "support/hosted_process.h"

namespace {

using namespace std::chrono_literals;
using reference::PoseStamped;
using suture::Errc;
using suture::HistoryEntry;
using suture::now;
using Kind = HistoryEntry::Kind;

constexpr suture::Duration kDeadline = 200ms;
constexpr double kMoveTakes = 0.01;  // s

struct Port final : suture::Required<reference::ArmLike> {
  using Required::channel;
  using Required::Required;
};

class Client final : public suture::Device {
 public:
  Client(const std::string& log, std::uint32_t number) : log_(log), number_(number) {
    arm.on().arrived([this](const PoseStamped& tag) {
      note({.kind = Kind::Heard,
            .id = static_cast<std::uint64_t>(tag.pose.translation().y()),
            .epoch = static_cast<std::uint64_t>(tag.pose.translation().x())});
    });
  }

  void ask() {
    (void)arm.connected();
    if (arm.channel() != known_) {
      known_ = arm.channel();
      ++epoch_;
    }
    const PoseStamped goal = sent(0ms);
    const auto posted = arm.servo_cp(goal);
    noteEnd(posted ? Errc{} : posted.error());
    const PoseStamped target = sent(kDeadline);
    const auto moved = arm.move.start(target, kMoveTakes, "").within(kDeadline);
    noteEnd(moved ? Errc{} : moved.error());
  }

  Port arm{*this, "Arm"};

 private:
  void note(HistoryEntry entry) {
    entry.at = now();
    entry.client = number_;
    log_.write(entry);
  }
  PoseStamped sent(suture::Duration deadline) {
    ++id_;
    note({.kind = Kind::Sent, .id = id_, .epoch = epoch_, .limit = deadline});
    PoseStamped tag;
    tag.pose.translation() << number_, static_cast<double>(id_), static_cast<double>(epoch_);
    tag.stamp = now();
    tag.valid = true;
    return tag;
  }
  void noteEnd(Errc error) {
    note({.kind = Kind::Ended, .id = id_, .epoch = epoch_, .error = error});
  }

  suture::HistoryLog log_;
  const std::uint32_t number_;
  std::uint64_t id_ = 0, epoch_ = 0;
  std::shared_ptr<suture::Channel> known_;
};

/// As often as it is refused, unless it is to end.
void connect(const suture::HostedProcess& process, suture::Manager& manager, const std::string& arm,
             suture::Duration silence) {
  while (!process.ended()) {
    try {
      manager.connect("Client/Arm", arm, suture::Lane::Auto, 60s, {}, {.silence = silence});
      return suture::say("ready");
    } catch (const suture::SetupError&) {
      std::this_thread::sleep_for(5ms);
    }
  }
}

}  // namespace

int main(int, char** argv) {
  const bool busy = std::string_view(argv[6]) == "busy";
  return suture::statusOf([argv, busy] {
    const suture::HostedProcess process;
    Client client(argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("Client", client);
    manager.start();
    suture::say("begun");
    const auto silence = std::chrono::milliseconds(std::atoi(argv[7]));
    connect(process, manager, std::string(argv[5]) + ":PSM/Arm", silence);
    while (!process.ended()) {
      client.waitForEvents(now() + 5ms);
      client.processEvents();
      if (busy) client.ask();
    }
    manager.stop();
  });
}
