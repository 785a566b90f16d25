#pragma once
// This offers a task's timing as a provided interface.

#include <suture/component/task/task.h>
#include <suture/standard/task_timing.suture.h>

#include <atomic>
#include <string_view>

namespace suture {

/// A TimingPort is a member of a task. Its reads are evaluated in the task's thread, and only once
/// a client has asked for them.
///   suture::TimingPort timing_{*this};          others connect to "PSM/Timing"
class TimingPort final : private TaskTiming {
 public:
  explicit TimingPort(Task& task, std::string_view name = "Timing")
      : task_(task), port_(task, name, *this) {}

 private:
  TaskWindow window() const override { return task_.statistics().windows.last(); }
  std::uint64_t cycles() const override {
    return task_.statistics().cycles.load(std::memory_order_relaxed);
  }
  std::uint64_t skipped() const override {
    return task_.statistics().skipped.load(std::memory_order_relaxed);
  }

  Task& task_;
  Provided<TaskTiming> port_;
};

}  // namespace suture
