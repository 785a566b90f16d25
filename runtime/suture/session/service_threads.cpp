#include <suture/component/task/task.h>
#include <suture/lane/delay/delay_thread.h>
#include <suture/session/device_executor.h>
#include <suture/session/service_threads.h>

namespace suture {

ServiceThreads::ServiceThreads() = default;

ServiceThreads::~ServiceThreads() = default;

void ServiceThreads::schedule(const rt::Scheduling& scheduling) {
  const std::lock_guard lock(mutex_);
  scheduling_ = scheduling;
}

std::shared_ptr<rt::Doorbell> ServiceThreads::serverOf(ProvidedBase& provided) {
  if (provided.owner().ownsThread()) return provided.owner().sharedDoorbell();
  const std::lock_guard lock(mutex_);
  if (executor_ == nullptr) executor_ = std::make_unique<DeviceExecutor>(scheduling_);
  executor_->serve(provided);
  return executor_->sharedDoorbell();
}

const Task* ServiceThreads::taskOf(const Component& component) const {
  if (component.ownsThread()) return static_cast<const Task*>(&component);
  const std::lock_guard lock(mutex_);
  return executor_.get();
}

DelayThread* ServiceThreads::delaysFor(const ConnectionDelay& delay) {
  if (!delay.any()) return nullptr;
  if (delays_ == nullptr) delays_ = std::make_unique<DelayThread>(scheduling_);
  return delays_.get();
}

void ServiceThreads::refuseToStopInCycle() const {
  const std::lock_guard lock(mutex_);
  if (executor_ != nullptr) executor_->refuseToStopInCycle();
}

// The executor and the delays ring each other, so it stops before they end, and ends behind them.
void ServiceThreads::stop() {
  if (executor_ != nullptr) executor_->stop();
  delays_.reset();
  executor_.reset();
}

}  // namespace suture
