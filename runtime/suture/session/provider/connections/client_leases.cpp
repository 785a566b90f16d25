#include <suture/loop/deadline.h>
#include <suture/session/provider/connections/client_leases.h>

#include <algorithm>

namespace suture {

void ClientLeases::watch(ProviderEnd& end) {
  if (end.endOfLease() == BootTime::max()) return;
  ends_.push_back(kj::addRef(end));
  watching_ = look().eagerlyEvaluate(nullptr);
}

void ClientLeases::hear(std::int64_t sent) {
  if (sent == 0 || sent != answered_) return;
  client_->heard.store(answeredAt_, std::memory_order_relaxed);
}

std::int64_t ClientLeases::answer() {
  answeredAt_ = BootClock::now();
  return answered_ = toNanoseconds(now());
}

// The thread that executes sees itself that a lease has ended. If no command waits to be executed,
// only this sees it.
kj::Promise<void> ClientLeases::look() {
  const BootTime present = BootClock::now();
  std::erase_if(ends_, [](const auto& one) { return one->endOfLease() == BootTime::max(); });
  BootTime next = BootTime::max();
  for (auto& end : ends_) {
    if (end->endOfLease() <= present) end->lapse();
    next = std::min(next, end->endOfLease());
  }
  if (next == BootTime::max()) return kj::READY_NOW;
  return control_.timer().afterDelay(loop::toKj(next - present)).then([this] { return look(); });
}

}  // namespace suture
