#include <suture/component/provided/command_clock.h>

#include <algorithm>
#include <chrono>

namespace suture {
namespace {

// The reads of two clocks lie apart by tens of ns, and no machine sleeps for less than this.
constexpr Duration kShortestSleep = std::chrono::milliseconds(1);

// A command that has waited through two sleeps is older by both.
constexpr Duration kLongestWait = std::chrono::minutes(1);

}  // namespace

// Compares a few times, because it would take a pause in the first comparison for a sleep when it
// makes the next.
CommandClock::CommandClock() {
  Time steady;
  ahead_ = compare(steady);
  for (int i = 0; i < 2; ++i) ahead_ = std::max(ahead_, compare(steady));
}

Duration CommandClock::compare(Time& steady) {
  look();
  steady = now();
  return present_.time_since_epoch() - steady.time_since_epoch();
}

void CommandClock::begin() {
  Time steady;
  const Duration gained = compare(steady) - ahead_;
  if (gained <= Duration{0}) return;
  ahead_ += gained;
  if (gained < kShortestSleep) return;
  slept_ = steady - noticed_ < kLongestWait ? slept_ + gained : gained;
  noticed_ = steady;
}

}  // namespace suture
