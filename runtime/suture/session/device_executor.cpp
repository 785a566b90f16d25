#include <suture/rt/state/state_table.h>
#include <suture/session/device_executor.h>

#include <algorithm>

namespace suture {

DeviceExecutor::DeviceExecutor(const rt::Scheduling& scheduling) : ThreadTask(scheduling) {
  start();
}

DeviceExecutor::~DeviceExecutor() { stop(); }

void DeviceExecutor::serve(ProvidedBase& device) {
  {
    const std::lock_guard lock(mutex_);
    added_.push_back(&device);
  }
  doorbell().ring();
}

void DeviceExecutor::takeOver() {
  const std::lock_guard lock(mutex_);
  for (ProvidedBase* device : added_) {
    const bool known = std::any_of(served_.begin(), served_.end(), [device](const Served& served) {
      return served.interface == device;
    });
    if (!known) served_.push_back({device, now()});
  }
  added_.clear();
}

bool DeviceExecutor::awaitCycle() {
  Time due = Time::max();
  for (const Served& served : served_) {
    if (served.interface->demand() != 0) due = std::min(due, served.rowDue);
  }
  const bool waiting = std::any_of(served_.begin(), served_.end(), [](const Served& served) {
    return served.interface->pending();
  });
  if (ending() || waiting) return !ending();
  mutableActivity().sleep(due);
  doorbell().waitUntil(due);
  return !ending();
}

void DeviceExecutor::serveOnce(Served& served) {
  Component& device = served.interface->owner();
  device.parkOnThrow([&] {
    served.interface->drain();
    if (now() < served.rowDue) return;
    served.rowDue = now() + device.remoteReadPeriod();
    if (served.interface->inService()) served.interface->publishRow();
  });
}

void DeviceExecutor::run() {
  takeOver();
  for (Served& served : served_) {
    serveOnce(served);
  }
}

}  // namespace suture
