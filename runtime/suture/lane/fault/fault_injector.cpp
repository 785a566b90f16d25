#include <suture/lane/fault/fault_injector.h>

namespace suture {
namespace {

std::mt19937_64 randomOf(std::uint64_t seed, std::uint64_t stream) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(stream)};
  return std::mt19937_64(sequence);
}

Duration part(Duration whole, double share) {
  return Duration(static_cast<std::int64_t>(static_cast<double>(whole.count()) * share));
}

}  // namespace

FaultInjector::FaultInjector(const FaultPlan& plan, std::uint64_t stream)
    : plan_(plan), random_(randomOf(plan.seed, stream)) {}

// Does not use the library's distributions, which may differ from one build to another.
double FaultInjector::draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

void FaultInjector::count(std::atomic<std::uint64_t> FaultCounts::*which) {
  if (plan_.counts != nullptr) (*plan_.counts.*which).fetch_add(1, std::memory_order_relaxed);
}

bool FaultInjector::isLost() {
  const bool alone = strikes(plan_.loss);
  if (strikes(plan_.burst) && burstLeft_ == 0) burstLeft_ = plan_.burstLength;
  if (burstLeft_ > 0) {
    --burstLeft_;
    count(&FaultCounts::burstLost);
    return true;
  }
  if (alone) count(&FaultCounts::lost);
  return alone;
}

/// Returns how often a message is delayed whose `draw` is below the chance of a delay. One draw is
/// enough: it is below a product of chances as rarely as that many draws would each be below their
/// own.
int FaultInjector::times(double draw) const {
  constexpr int kMost = 100;  // bounds a message that is always delayed again
  int count = 1;
  for (double chance = plan_.delay * plan_.delayAgain; draw < chance && count < kMost; ++count) {
    chance *= plan_.delayAgain;
  }
  return count;
}

// Draws equally often for each message, so that the faults of one do not change those of the next.
Fate FaultInjector::next() {
  const bool lost = isLost();
  const bool duplicated = strikes(plan_.duplicate), reordered = strikes(plan_.reorder);
  const double delay = draw();
  const bool stalled = strikes(plan_.stall);
  const double jitter = draw(), again = draw();
  if (lost) return {.lost = true};
  Fate fate;
  if (duplicated) {
    fate.duplicated = true;
    fate.duplicateLater = part(plan_.holdBack, again);
    count(&FaultCounts::duplicated);
  }
  if (delay < plan_.delay) {
    fate.later += times(delay) * plan_.delayLength;
    count(&FaultCounts::delayed);
  }
  if (reordered) {
    fate.overtakable = true;
    fate.later += plan_.holdBack;
    count(&FaultCounts::reordered);
  }
  if (plan_.jitter > Duration{0}) {
    fate.overtakable = fate.overtakable || !plan_.ordered;
    fate.later += part(plan_.jitter, jitter);
    count(&FaultCounts::jittered);
  }
  if (stalled) {
    fate.stall = plan_.stallLength;
    count(&FaultCounts::stalls);
  }
  return fate;
}

}  // namespace suture
