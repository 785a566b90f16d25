#include "bench/stop/system.h"

#include <signal.h>
#include <suture/base/errors.h>

#include <chrono>
#include <thread>

#include "bench/network/lanes.h"
#include "bench/placement.h"
#include "bench/stop/stop_process.h"

namespace bench {

using namespace std::chrono_literals;
using robots::DrivePower;
using suture::now;
using suture::Time;

StopSystem::StopSystem(const suture::Lane& lane) : isOneProcess_(lane == suture::Lane::Auto) {
  if (isOneProcess_) {
    manager_.emplace("bench");
    addHere();
  } else {
    names_.emplace(Transport::Unix);
    manager_.emplace("bench", names_->address());
    manager_->scheduleService(urgent(70));
    startElsewhere(lane);
  }
  manager_->add("Panel", panel_);
  manager_->add("Watch", watch_);
  manager_->start();
  if (isOneProcess_) {
    connectPair(*manager_, *left_, {}, lane);
    connectPair(*manager_, *right_, {}, lane);
    connectVision(*manager_, {}, lane);
  }
  connectWatchers(lane);
  release();
}

StopSystem::~StopSystem() { manager_->stop(); }

std::uint64_t StopSystem::end() {
  if (isOneProcess_) return left_->viewer.images() + right_->viewer.images();
  std::uint64_t images = 0;
  for (const auto& process : processes_) {
    if (deskIsKilled_ && process == processes_.front()) continue;
    for (const std::uint64_t seen : resultIn<std::uint64_t>(process->finish())) images += seen;
  }
  return images;
}

void StopSystem::addHere() {
  desk_.emplace();
  left_.emplace(0, robots::Side::Left);
  right_.emplace(2, robots::Side::Right);
  vision_.emplace();
  desk_->addTo(*manager_);
  vision_->addTo(*manager_);
  left_->addTo(*manager_);
  right_->addTo(*manager_);
}

void StopSystem::startElsewhere(const suture::Lane& lane) {
  for (const char* const process : {"desk", "left", "right", "vision"}) {
    processes_.push_back(
        std::make_unique<ChildProcess>(stopProcessArguments(process, names_->address(), lane)));
  }
}

void StopSystem::connectWatchers(const suture::Lane& lane) {
  const auto connect = [&](const std::string& required, const char* process,
                           const std::string& provided) {
    if (isOneProcess_) return manager_->connect(required, provided);
    connectBy(lane, *manager_, required, std::string(process) + ":" + provided);
  };
  connect("Panel/Stop", "desk", "Coordinator/Stop");
  for (const ArmPlace& arm : kArms) {
    const std::string name = arm.name;
    connect("Panel/" + name, arm.process, name + "/Arm");
    connect("Watch/" + name, arm.process, name + "Drives/Drives");
  }
}

/// Throws SetupError if there are no `what` after 10 s.
template <class Condition>
void StopSystem::await(const char* what, const Condition& condition) const {
  const Time deadline = now() + 10s;
  while (!condition()) {
    if (now() > deadline) {
      throw suture::SetupError(what, "this was not so after 10 s", "Run it again");
    }
    std::this_thread::sleep_for(500us);
  }
}

/// Asks again and again, because an arm refuses until it has seen that its drives may have power.
void StopSystem::enableAll() {
  await("drives that may have power", [this] { return watch_.all(DrivePower::Off); });
  Time asked{};
  await("drives with power", [&] {
    if (now() - asked > 10ms) {
      for (suture::Required<robots::Arm>* arm : panel_.arms()) (void)arm->enable();
      asked = now();
    }
    return watch_.all(DrivePower::On);
  });
  watch_.reset();
}

std::int64_t StopSystem::untilStopped(Time from) {
  await("drives that have stopped", [this] { return watch_.allStopped() != Time{}; });
  return (watch_.allStopped() - from).count();
}

void StopSystem::release() {
  await("a press that can be released", [this] { return panel_.release(); });
}

std::int64_t StopSystem::press() {
  enableAll();
  const Time pressed = now();
  (void)panel_.stop.press();
  const std::int64_t took = untilStopped(pressed);
  release();
  return took;
}

std::int64_t StopSystem::cutOff() {
  const std::int64_t took = signalDesk(SIGSTOP);
  kill(processes_.front()->pid(), SIGCONT);
  return took;
}

std::int64_t StopSystem::killDesk() {
  deskIsKilled_ = true;
  return signalDesk(SIGKILL);
}

std::int64_t StopSystem::signalDesk(int signal) {
  enableAll();
  const Time sent = now();
  kill(processes_.front()->pid(), signal);
  return untilStopped(sent);
}

}  // namespace bench
