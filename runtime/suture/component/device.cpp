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

// The event whose handler runs is still the first of its queue, so it would be handled again.
Errc Device::cannotHandle() {
  if (!ownedByThisThread()) return Errc::WrongThread;
  const bool handling =
      std::any_of(required().begin(), required().end(),
                  [](const RequiredBase* interface) { return interface->handling(); });
  return handling ? Errc::CannotWait : Errc{};
}

Result<void> Device::processEvents() {
  if (const Errc error = cannotHandle(); error != Errc{}) return tl::unexpected(error);
  handleEvents();
  return {};
}

bool Device::waitForEvents(Time deadline) {
  if (cannotHandle() != Errc{}) return false;
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
