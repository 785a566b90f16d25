#include "04_contract_and_loss/follower.h"

#include <chrono>
#include <cstdio>

namespace following {

Follower::Follower() : PeriodicTask({.period = std::chrono::milliseconds(10)}) {}

// The contract of the connection decides what a read answers; this code asks only if it may act on
// the answer.
void Follower::run() {
  const auto angle = joystick_.angle();
  if (angle.error() != told_) tell(angle.error(), angle ? "follows from" : "holds at");
  constexpr double kGain = 0.1;  // it takes this part of the difference in each cycle
  if (angle) position_ += kGain * (*angle - position_);
}

// Printing may take its time, so it is done only at a change. A real controller would leave it to a
// client that receives an event.
void Follower::tell(suture::Errc state, const char* reaction) {
  told_ = state;
  const bool good = state == suture::Errc{};
  const char* const news = !good ? toString(state) : lost_ ? "back" : "fresh";
  std::printf("%s: %s %.3f rad\n", news, reaction, position_);
  std::fflush(stdout);
  lost_ = state == suture::Errc::Lost || (lost_ && !good);
}

}  // namespace following
