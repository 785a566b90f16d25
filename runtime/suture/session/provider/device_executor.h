#pragma once
// The thread that serves remote clients of devices, which have none of their own.

#include <suture/component/provided.h>
#include <suture/component/task/thread_task.h>

#include <memory>
#include <mutex>
#include <vector>

namespace suture {

/// Executes the commands of remote clients as they arrive, and evaluates the reads they asked for
/// at the period the device declares. Exists only in a process whose devices have remote clients.
class DeviceExecutor final : public ThreadTask {
 public:
  explicit DeviceExecutor(const rt::Scheduling& scheduling);
  ~DeviceExecutor() override;

  /// Any thread: serves `device` from now on.
  void serve(ProvidedBase& device);

 private:
  struct Served {
    ProvidedBase* interface;
    Time rowDue;
  };

  bool awaitCycle() override;
  void run() override;
  void takeOver();
  static void serveOnce(Served& served);

  std::mutex mutex_;  // devices are added rarely, and no control loop waits here
  std::vector<ProvidedBase*> added_;
  std::vector<Served> served_;
};

}  // namespace suture
