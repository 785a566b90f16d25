#pragma once
// This is a task that fails all the time.

#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <stdexcept>

namespace suture {

/// Throws in each 25th cycle, and runs again.
class ShakyTask final : public PeriodicTask {
 public:
  ShakyTask() : PeriodicTask({.period = std::chrono::milliseconds(2)}) {
    restartAfterFaults({.most = 16, .per = std::chrono::milliseconds(100)});
  }
  ~ShakyTask() override { stop(); }

 private:
  void run() override {
    if (++cycles_ % 25 == 0) throw std::runtime_error("a loose contact");
  }

  int cycles_ = 0;
};

}  // namespace suture
