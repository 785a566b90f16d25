#pragma once

#include <suture/component/task/task.h>

namespace suture {

/// Runs its cycles in the thread of another task, after that task's own: Task::lend(). What arrives
/// for the guest wakes that thread.
class GuestTask : public Task {
 public:
  /// Checks that it has a host, with which it starts and stops. Throws SetupError if it has none.
  void start() final;
  void stop() final {}

 private:
  friend class Task;

  void accept(Task& host);

  Task* host_ = nullptr;
};

}  // namespace suture
