#pragma once
// This is the client of all scenarios: it runs what the test gives it in the thread that owns the
// required interface.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "conformance/ends/arm.h"
#include "support/eventually.h"

namespace conformance {

using Arm = suture::Required<ArmLike>;
using Gripper = suture::Required<GripperArm>;

/// Holds what arrived as events.
struct Received {
  std::vector<Mode> modes;
  std::vector<double> arrivals;
  std::vector<std::pair<double, double>> moves;
  std::vector<double> grips;
  int stops = 0;
};

class Client {
 public:
  virtual ~Client() = default;
  virtual suture::Component& component() = 0;
  /// Runs `work` in the client's thread and returns when it has ended.
  virtual void with(const std::function<void(Arm&)>& work) = 0;
  /// Does the same with the other interface, where it is connected.
  void withGripper(const std::function<void(Gripper&)>& work) {
    with([&](Arm&) { work(gripper()); });
  }
  /// Lets the client look for events until `enough` says so of what has been received, at most 10
  /// s.
  virtual bool await(const std::function<bool(const Received&)>& enough) = 0;

 protected:
  virtual Gripper& gripper() = 0;
  static void listen(Gripper& gripper, Received& received) {
    gripper.on().gripped([&received](double width) { received.grips.push_back(width); });
  }
  static void listen(Arm& arm, Received& received) {
    arm.on().mode([&received](const Mode& mode) { received.modes.push_back(mode); });
    arm.on().arrived([&received](const PoseStamped& pose) {
      received.arrivals.push_back(pose.pose.translation().x());
    });
    arm.on().stopped([&received] { ++received.stops; });
    arm.on().moved([&received](const PoseStamped& pose, double speed) {
      received.moves.emplace_back(pose.pose.translation().x(), speed);
    });
  }
};

class TaskClient final : public suture::EventTask, public Client {
 public:
  TaskClient() {
    listen(arm_, received_);
    listen(gripper_, received_);
  }
  suture::Component& component() override { return *this; }
  void with(const std::function<void(Arm&)>& work) override {
    std::atomic<bool> done{false};
    {
      const std::lock_guard lock(mutex_);
      work_.push_back([&] {
        try {
          work(arm_);
        } catch (const std::exception& error) {
          ADD_FAILURE() << error.what();
        }
        done = true;
      });
    }
    doorbell().ring();
    while (!suture::eventually([&] { return done.load(); })) continue;  // it uses what lives here
  }
  bool await(const std::function<bool(const Received&)>& enough) override {
    return suture::eventually([&] {
      bool arrived = false;
      with([&](Arm&) { arrived = enough(received_); });
      return arrived;
    });
  }

 private:
  void run() override {
    std::vector<std::function<void()>> work;
    {
      const std::lock_guard lock(mutex_);
      work.swap(work_);
    }
    for (const auto& each : work) each();
  }

  std::mutex mutex_;
  std::vector<std::function<void()>> work_;
  Received received_;
  Gripper& gripper() override { return gripper_; }

  Arm arm_{*this, "Arm"};
  Gripper gripper_{*this, "Gripper"};
};

class DeviceClient final : public suture::Device, public Client {
 public:
  DeviceClient() {
    listen(arm_, received_);
    listen(gripper_, received_);
  }
  suture::Component& component() override { return *this; }
  void with(const std::function<void(Arm&)>& work) override { work(arm_); }
  bool await(const std::function<bool(const Received&)>& enough) override {
    const auto deadline = suture::now() + std::chrono::seconds(10);
    processEvents();
    while (!enough(received_) && suture::now() < deadline) waitForEvents(deadline);
    return enough(received_);
  }

 private:
  Received received_;
  Gripper& gripper() override { return gripper_; }

  Arm arm_{*this, "Arm"};
  Gripper gripper_{*this, "Gripper"};
};

}  // namespace conformance
