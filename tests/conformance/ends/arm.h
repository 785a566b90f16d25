#pragma once
// This is the provider of all scenarios: an ArmLike that writes down what it was told, as a task or
// as a device.

#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "conformance/ends/gate.h"
#include "fault/history/history.h"
#include "reference/gripper_arm.suture.h"

namespace conformance {

using reference::ArmLike;
using reference::GripperArm;
using reference::JointState;
using reference::Mode;
using reference::PoseStamped;

/// Any thread may read its log. Implements the contract.
class RecordingArm : public GripperArm {
 public:
  /// The gate holds up set_mode(Disabled) and move(..., "wait").
  explicit RecordingArm(Gate& tests) : gate(tests) {}

  void servo_cp(const PoseStamped& goal) override {
    writeHistory(goal, std::chrono::milliseconds(500));
    goTo(goal);
  }
  void servo_jp(const JointState& goal) override {
    {
      const std::lock_guard lock(mutex_);
      joints_ = goal;
    }
    log("servo_jp " + std::to_string(goal.position.size()));
  }
  void hold() override { log("hold"); }
  void set_mode(Mode mode) override {
    if (mode == Mode::Disabled) {
      gate.pass();
    } else if (throwOnEnable) {
      throw std::runtime_error("the drive did not answer");
    }
    log(mode == Mode::Enabled ? "enable" : "disable");
  }
  PoseStamped measured_cp() const override {
    const std::lock_guard lock(mutex_);
    evaluated_ = suture::now();
    if (!garbled_) return measured_;
    PoseStamped nowhere = measured_;
    nowhere.pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
    return nowhere;
  }
  const JointState& measured_js() const override { return outgrown_ ? tooLarge_ : joints_; }
  double distance(const PoseStamped& to) const override {
    answeredBy_ = getpid();
    ++distances_;
    return (measured_cp().pose.translation() - to.pose.translation()).norm();
  }

  bool move(const PoseStamped& goal, double speed, const std::string& reason) override {
    if (reason == "wait") gate.pass();
    if (reason == "throw") throw std::runtime_error("the drive did not answer");
    writeHistory(goal, {});
    goTo(goal);
    log("move " + std::to_string(static_cast<int>(speed * 100)) + "% " + reason);
    return speed > 0.5;
  }
  std::uint32_t reset() override {
    const std::lock_guard lock(mutex_);
    const auto forgotten = static_cast<std::uint32_t>(log_.size());
    log_.clear();
    return forgotten;
  }
  void limit(double speed, Mode mode) override {
    log("limit " + std::to_string(static_cast<int>(speed)) +
        (mode == Mode::Enabled ? " enabled" : " disabled"));
  }
  double close(double width) override {
    log("close");
    opening_ = width / 2;
    return opening_;
  }
  double opening() const override { return opening_; }
  void release() override {
    log("release");
    ranIn_ = gettid();
  }
  bool fits(double width) const override {
    if (width < 0) throw std::runtime_error("no such width");
    ranIn_ = gettid();
    return width < 0.1;
  }
  /// Returns the process in which the last distance() ran.
  pid_t answeredBy() const { return answeredBy_; }
  /// Returns what it has been told of its clients, in order: "console:Teleop/Slave connected".
  std::vector<std::string> clients() const {
    const std::lock_guard lock(mutex_);
    return clients_;
  }
  /// Returns the thread, of all on this machine, in which the last release() or fits() ran.
  pid_t ranIn() const { return ranIn_; }

  std::vector<std::string> taken() const {
    const std::lock_guard lock(mutex_);
    return log_;
  }

  /// Returns when the pose was last asked of it.
  suture::Time evaluated() const {
    const std::lock_guard lock(mutex_);
    return evaluated_;
  }
  /// Any thread: from now on its joints do not fit what the contract declares.
  void outgrow() { outgrown_ = true; }
  /// Any thread: if `garbled`, what it measures, and what it answers from that, is no number.
  void garble(bool garbled) { garbled_ = garbled; }
  /// Writes down each goal from now on: its place is its client, its number and its connection.
  void keepHistory(const std::string& file) {
    const std::lock_guard lock(mutex_);
    history_.emplace(file);
  }
  /// Returns how many of its commands are in no history: none but distance() is sent beside goals.
  std::uint64_t others() const { return distances_; }
  /// Notes what the report of its process says of the commands of client number 1.
  void noteLedger(const suture::HistorySums& sums) {
    const std::lock_guard lock(mutex_);
    history_->write({.kind = suture::HistoryEntry::Kind::Served,
                     .at = suture::now(),
                     .client = 1,
                     .id = goals_ + others(),
                     .sums = sums});
  }

  Gate& gate;
  std::atomic<bool> throwOnEnable{false};

 protected:
  void note(const suture::ConnectedClient& client, suture::ClientNews news) {
    static constexpr const char* kNews[] = {" connected", " closed", " silent"};
    const std::lock_guard lock(mutex_);
    clients_.push_back(std::string(client.name) + kNews[static_cast<int>(news)]);
  }

 private:
  /// Returns how old the runtime found the command whose handler runs.
  virtual suture::Duration commandAge() const = 0;

  void log(std::string line) {
    const std::lock_guard lock(mutex_);
    log_.push_back(std::move(line));
  }
  void goTo(const PoseStamped& goal) {
    {
      const std::lock_guard lock(mutex_);
      measured_ = goal;
    }
    log("servo_cp " + std::to_string(static_cast<int>(goal.pose.translation().x())));
  }
  void writeHistory(const PoseStamped& goal, suture::Duration ttl) {
    const std::lock_guard lock(mutex_);
    if (!history_) return;
    ++goals_;
    const auto& tag = goal.pose.translation();
    history_->write({.kind = suture::HistoryEntry::Kind::Executed,
                     .at = suture::now(),
                     .client = static_cast<std::uint32_t>(tag.x()),
                     .id = static_cast<std::uint64_t>(tag.y()),
                     .epoch = static_cast<std::uint64_t>(tag.z()),
                     .limit = ttl,
                     .age = commandAge()});
  }

  mutable std::mutex mutex_;
  std::vector<std::string> log_, clients_;
  std::optional<suture::HistoryLog> history_;
  std::uint64_t goals_ = 0;  // in the history
  PoseStamped measured_;
  mutable suture::Time evaluated_;
  JointState joints_;
  const JointState tooLarge_{{"a name of 16 chr"}, {}};
  std::atomic<bool> outgrown_{false}, garbled_{false};
  std::atomic<double> opening_{0};
  mutable std::atomic<pid_t> ranIn_{0}, answeredBy_{0};
  mutable std::atomic<std::uint64_t> distances_{0};
};

/// Holds what a component provides: the contract, and one that derives from it.
struct Ports {
  suture::Provided<ArmLike>& arm;
  suture::Provided<GripperArm>& gripper;
};

/// Emits, in the provider's own thread, what the test asks for.
class Emissions {
 public:
  void ask(std::function<void(Ports)> emission) {
    const std::lock_guard lock(mutex_);
    asked_.push_back(std::move(emission));
  }
  void perform(Ports ports) {
    std::vector<std::function<void(Ports)>> now;
    {
      const std::lock_guard lock(mutex_);
      now.swap(asked_);
    }
    for (const auto& emission : now) emission(ports);
  }

 private:
  std::mutex mutex_;
  std::vector<std::function<void(Ports)>> asked_;
};

/// An ArmComponent is what every kind of provider offers the test.
class ArmComponent : public RecordingArm {
 public:
  using RecordingArm::RecordingArm;
  virtual suture::Component& component() = 0;
  /// Runs `emission` where this kind of component emits.
  void emitSoon(std::function<void(Ports)> emission) {
    perform([this, emission = std::move(emission)](Ports ports) {
      emittedIn_ = gettid();
      emission(ports);
      ++emitted_;
    });
  }
  /// Returns how many emissions have run; the other tells in which thread the last one began.
  int emitted() const { return emitted_; }
  pid_t emittedIn() const { return emittedIn_; }

 private:
  virtual void perform(std::function<void(Ports)> emission) = 0;

  std::atomic<int> emitted_{0};
  std::atomic<pid_t> emittedIn_{0};
};

template <class Task>
class ArmTask final : public Task, public ArmComponent {
 public:
  template <class Options>
  ArmTask(Gate& tests, const Options& options) : Task(options), ArmComponent(tests) {}
  suture::Component& component() override { return *this; }

 private:
  void perform(std::function<void(Ports)> emission) override {
    emissions_.ask(std::move(emission));
    this->doorbell().ring();
  }
  suture::Duration commandAge() const override { return arm_.commandAge(); }
  void onClient(const suture::ProvidedBase&, const suture::ConnectedClient& client,
                suture::ClientNews news) override {
    note(client, news);
  }
  void run() override { emissions_.perform({arm_, gripper_}); }

  Emissions emissions_;
  suture::Provided<ArmLike> arm_{*this, "Arm", *this};
  suture::Provided<GripperArm> gripper_{*this, "Gripper", *this};
};

class ArmDevice final : public suture::Device, public ArmComponent {
 public:
  explicit ArmDevice(Gate& tests) : Device(std::chrono::milliseconds(2)), ArmComponent(tests) {}
  suture::Component& component() override { return *this; }

 private:
  void perform(std::function<void(Ports)> emission) override { emission({arm_, gripper_}); }
  suture::Duration commandAge() const override { return arm_.commandAge(); }
  void onClient(const suture::ProvidedBase&, const suture::ConnectedClient& client,
                suture::ClientNews news) override {
    note(client, news);
  }

  suture::Provided<ArmLike> arm_{*this, "Arm", *this};
  suture::Provided<GripperArm> gripper_{*this, "Gripper", *this};
};

}  // namespace conformance
