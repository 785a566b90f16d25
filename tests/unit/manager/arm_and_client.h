#pragma once
// This is an arm and a client that holds it in each cycle, for tests of the connection between
// them.

#include <suture/component/device.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "reference/still_arm.h"
#include "support/pass.h"

namespace suture::test {

using namespace std::chrono_literals;

/// A task that provides an arm; its mode is latched.
struct ArmTask final : PeriodicTask, StillArm {
  ArmTask() : PeriodicTask({.period = 1ms}) {}
  ~ArmTask() override { stop(); }
  void run() override {
    if (broken) throw std::runtime_error("the drive did not answer");
  }
  void set_mode(reference::Mode mode) override { port.emit().mode(mode); }
  void onClient(const ProvidedBase& interface, const ConnectedClient&, ClientNews news) override {
    if (&interface == &port) clients += news == ClientNews::Connected ? 1 : -1;
  }
  Provided<reference::ArmLike> port{*this, "Arm", *this};
  std::atomic<int> clients{0};
  std::atomic<bool> broken{false};
};

struct ArmDevice final : Device, StillArm {
  void set_mode(reference::Mode mode) override { port.emit().mode(mode); }
  Provided<reference::ArmLike> port{*this, "Arm", *this};
};

struct Client final : PeriodicTask {
  Client() : PeriodicTask({.period = 1ms}) {
    slave.on().mode([this](reference::Mode) { ++modes; });
  }
  ~Client() override { stop(); }
  void run() override {
    if (read) {
      pass(1us);  // what was published at the same instant has no age
      (void)slave.measured_cp();
    }
    const auto held = slave.hold();
    error = held ? Errc{} : held.error();
    if (ask && !call) {
      call.emplace(slave.set_mode.start(reference::Mode::Enabled));
      asked = true;
    }
    if (call && call->poll()) answer = *call->poll() ? Errc{} : call->poll()->error();
  }
  Required<reference::ArmLike> slave{*this, "Slave"};
  std::atomic<Errc> error{Errc::NotYet}, answer{Errc::NotYet};
  std::atomic<bool> ask{false}, asked{false}, read{false};
  std::atomic<int> modes{0};
  std::optional<Call<Result<void>, NoSlot>> call;
};

/// Holds an arm and its client, running in one process.
template <class Arm>
struct OneProcess {
  OneProcess() {
    manager.add("PSM", arm);
    manager.add("Teleop", client);
    manager.start();
  }
  void connect(const ConnectionContract& contract = {}) {
    manager.connect("Teleop/Slave", "PSM/Arm", {.patience = 1s, .contract = contract});
  }
  void disconnect() { manager.disconnect("Teleop/Slave"); }

  Arm arm;
  Client client;
  Manager manager{"here"};
};

}  // namespace suture::test
