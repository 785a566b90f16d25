#pragma once
// This thread carries all delayed connections of a process.

#include <suture/component/required.h>
#include <suture/component/task/thread_task.h>
#include <suture/lane/delay/delayed_connection.h>

#include <memory>
#include <mutex>
#include <vector>

namespace suture {

/// Exists only in a process that delays connections. Each connection has its own lines, so none
/// affects another. Ends its connections when it ends, which must be after the tasks.
class DelayThread final : public ThreadTask {
 public:
  explicit DelayThread(const rt::Scheduling& scheduling);
  ~DelayThread() override;

  /// Throws SetupError if the contract has a type without bounds, because what is under way is kept
  /// in memory of a fixed size.
  static void requireBounded(const InterfaceInfo& contract);

  /// Any thread. Puts a delay between `required` and `far`, whose client doorbell is this thread's.
  /// Returns the channel to be attached to `required`.
  std::shared_ptr<Channel> interpose(const RequiredBase& required, std::shared_ptr<Channel> far,
                                     const ConnectionDelay& delay);

 private:
  bool awaitCycle() override;
  void run() override;
  void takeOver();

  std::mutex mutex_;  // no control loop waits for it, because connections are made rarely
  std::vector<std::unique_ptr<DelayedConnection>> added_;
  std::vector<std::unique_ptr<DelayedConnection>> carried_;
};

}  // namespace suture
