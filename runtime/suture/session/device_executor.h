#pragma once
// This thread serves remote clients of devices, which have no thread.

#include <suture/component/provided.h>
#include <suture/component/task/thread_task.h>

#include <memory>
#include <mutex>
#include <vector>

namespace suture {

/// Executes the commands of remote clients as they arrive, and evaluates the reads that they asked
/// for at the period that the device declares. It exists only in a process whose devices have
/// remote clients.
class DeviceExecutor final : public ThreadTask {
 public:
  explicit DeviceExecutor(const rt::Scheduling& scheduling);
  ~DeviceExecutor() override;

  /// Any thread. Serves `device` from now on.
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

  std::mutex mutex_;  // no control loop waits for it, because devices are added rarely
  std::vector<ProvidedBase*> added_;
  std::vector<Served> served_;
};

}  // namespace suture
