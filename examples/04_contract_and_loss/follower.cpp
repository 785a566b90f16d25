#include "04_contract_and_loss/follower.h"

#include <chrono>
#include <cstdio>

namespace following {

Follower::Follower() : PeriodicTask({.period = std::chrono::milliseconds(10)}) {}

// What a read answers is decided by the contract of the connection: this code asks only whether it
// may act on the answer.
void Follower::run() {
  const auto angle = joystick_.angle();
  if (angle.error() != told_) tell(angle.error(), angle ? "follows from" : "holds at");
  constexpr double kGain = 0.1;  // of what is missing, in each cycle
  if (angle) position_ += kGain * (*angle - position_);
}

// Printing may take its time. It is done at a change only, and a real controller would leave it to
// somebody who hears an event.
void Follower::tell(suture::Errc state, const char* reaction) {
  told_ = state;
  const bool good = state == suture::Errc{};
  const char* const news = !good ? toString(state) : lost_ ? "back" : "fresh";
  std::printf("%s: %s %.3f rad\n", news, reaction, position_);
  std::fflush(stdout);
  lost_ = state == suture::Errc::Lost || (lost_ && !good);
}

}  // namespace following
