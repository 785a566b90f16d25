#pragma once
// These components keep a diary of their lives, for the tests of the life cycle.

#include <suture/component/lifecycle.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/arm_like.suture.h"
#include "reference/simulated_arm.h"
#include "support/eventually.h"

namespace suture {

/// Any thread may use this. Keeps what has happened, in order, and in which threads.
class Diary {
 public:
  void note(const std::string& what) {
    const std::lock_guard lock(mutex_);
    entries_.push_back(what);
    threads_.push_back(std::this_thread::get_id());
  }
  std::vector<std::string> entries() const {
    const std::lock_guard lock(mutex_);
    return entries_;
  }
  std::vector<std::thread::id> threads() const {
    const std::lock_guard lock(mutex_);
    return threads_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> entries_;
  std::vector<std::thread::id> threads_;
};

/// This is a task that counts its cycles.
template <class Kind>
struct Cycling : Kind {
  using Kind::Kind;
  void run() override { ++cycles; }
  std::atomic<int> cycles{0};
};

template <class Kind>
using WithCycles = std::conditional_t<std::is_base_of_v<Task, Kind>, Cycling<Kind>, Kind>;

/// Provides an arm and writes each hook that runs into a diary. The hook that `throwing` names
/// throws.
template <class Kind>
struct Living final : WithCycles<Kind> {
  template <class... Arguments>
  explicit Living(Arguments&&... arguments)
      : WithCycles<Kind>(std::forward<Arguments>(arguments)...) {}
  ~Living() override { this->stop(); }

  void onConfigure() override { hook("configure"); }
  void onStart() override { hook("start"); }
  void onSuspend() override { hook("suspend"); }
  void onResume() override { hook("resume"); }
  void onStop() override { hook("stop"); }

  void hook(const std::string& name) {
    diary.note(name);
    if (name == throwing) throw std::runtime_error("no " + name + " today");
  }

  std::string throwing;
  Diary diary;
  reference::SimulatedArm simulated{{}};
  Provided<reference::ArmLike> arm{*this, "Arm", simulated};
};

inline const PeriodicOptions kQuick{.period = std::chrono::milliseconds(1)};

inline bool reaches(const Component& component, ComponentState state) {
  return eventually([&] { return component.state() == state; });
}

}  // namespace suture
