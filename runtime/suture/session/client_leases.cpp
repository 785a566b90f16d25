#include <suture/loop/deadline.h>
#include <suture/session/client_leases.h>

#include <algorithm>

namespace suture {
namespace {

// Bounds what a client says, since sums with it have to fit.
constexpr Duration kLongestSilence = std::chrono::hours(24 * 365);

}  // namespace

void ClientLeases::grant(rpc::ProviderEnd& end, std::int64_t silence) {
  if (silence <= 0) return;
  end.grant(std::min(Duration(silence), kLongestSilence));
  ends_.add(kj::addRef(end));
  watching_ = watch().eagerlyEvaluate(nullptr);
}

void ClientLeases::hear(std::int64_t sent) {
  if (sent == 0 || sent != answered_) return;
  for (auto& end : ends_) end->hear(answeredAt_);
}

std::int64_t ClientLeases::answer() {
  answeredAt_ = BootClock::now();
  return answered_ = toNanoseconds(now());
}

// The thread that executes sees for itself that a lease has ended. Where nothing waits to be
// executed, nobody but this sees it.
kj::Promise<void> ClientLeases::watch() {
  const BootTime present = BootClock::now();
  BootTime next = BootTime::max();
  for (auto& end : ends_) {
    if (end->endOfLease() <= present) end->lapse();
    next = std::min(next, end->endOfLease());
  }
  if (next == BootTime::max()) return kj::READY_NOW;
  return control_.timer().afterDelay(rpc::toKj(next - present)).then([this] { return watch(); });
}

}  // namespace suture
