#include <suture/component/device.h>
#include <suture/component/required.h>

#include <algorithm>

namespace suture {

void Device::start() {
  const std::lock_guard lock(changing_);
  if (after(state(), Transition::Configure)) configure();
  if (state() == ComponentState::Faulted) return;
  requireLegal(name(), state(), Transition::Start);
  makeTransition(Transition::Start);
}

void Device::stop() {
  const std::lock_guard lock(changing_);
  endLife();
}

void Device::take(Transition transition) {
  const std::lock_guard lock(changing_);
  requireLegal(name(), state(), transition);
  makeTransition(transition);
}

Result<void> Device::processEvents() {
  if (!ownedByThisThread()) return tl::unexpected(Errc::WrongThread);
  handleEvents();
  return {};
}

bool Device::waitForEvents(Time deadline) {
  if (!ownedByThisThread()) return false;
  const auto arrived = [this] {
    return std::any_of(required().begin(), required().end(),
                       [](const RequiredBase* interface) { return interface->pending(); });
  };
  while (!arrived() && now() < deadline) doorbell().waitUntil(deadline);
  const bool any = arrived();
  processEvents();
  return any;
}

}  // namespace suture
