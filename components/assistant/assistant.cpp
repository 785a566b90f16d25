#include "assistant/assistant.h"

#include <algorithm>
#include <chrono>

#include "arm/arm_warning.h"
#include "parameters/valid_time.h"

namespace robots {
namespace {

// A part that stops at most this long before or after a loss of power has stopped by it. The news
// of both come by connections of their own, which are made anew one after the other after a cut.
constexpr suture::Duration kSameCause = std::chrono::seconds(2);

}  // namespace

Assistant::Assistant(const AssistantParameters& parameters)
    : PeriodicTask({.period = parameters.period}), parameters_(parameters) {
  requireTimeOrZero("press_after", parameters.press_after);
  requireTime("release_after", parameters.release_after);
  requireTime("patience", parameters.patience);
  stop_.on().stop([this](const StopNews& news) { hear(news); });
  console_.on().console_state([this](const ConsoleState& state) { hear(state); });
  console_.on().system_use([this](const SystemUse& use) { use_ = use; });
  console_.on().warning([this](const suture::Message& warning) {
    if (warning.code == static_cast<std::uint32_t>(ArmWarning::PowerLost)) losePower();
  });
  left_.on().teleop_state(
      [this](const TeleopState& state) { tell(leftWaits_, state == TeleopState::Preparing); });
  right_.on().teleop_state(
      [this](const TeleopState& state) { tell(rightWaits_, state == TeleopState::Preparing); });
  guidance_.on().guidance_state([this](const GuidanceState& state) {
    tell(guidanceWaits_, state == GuidanceState::Preparing);
  });
}

void Assistant::run() {
  const suture::Time now = suture::now();
  followScript(now);
  if (!isReleased()) return;
  bringUpAgain(now);
  attend(left_, leftWaits_, now);
  attend(right_, rightWaits_, now);
  attend(guidance_, guidanceWaits_, now);
}

void Assistant::hear(const StopNews& news) {
  if (news.pressed && isReleased()) losePower();
  if (!stopNews_ || news.press != stopNews_->press) ++pressesHeard_;
  if (!news.pressed) released_ = suture::now();
  stopNews_ = news;
}

void Assistant::hear(const ConsoleState& state) {
  isDown_ = state == ConsoleState::Down;
  wasUp_ = wasUp_ || state == ConsoleState::Up;
  tell(consoleWaits_, !wasUp_ && (isDown_ || state == ConsoleState::Leaving));
}

/// The news of a loss may come before or after those of what has stopped by it.
void Assistant::losePower() {
  lost_ = suture::now();
  for (Waiting* const one : {&consoleWaits_, &leftWaits_, &rightWaits_, &guidanceWaits_}) {
    one->lostPower = one->lostPower || (one->since && lost_ - *one->since <= kSameCause);
    one->asked = false;
  }
}

// A step ends when the stop reports that it is as it was asked to be, because a command may be
// lost.
void Assistant::followScript(suture::Time now) {
  const suture::Duration since = now - stepped_;
  switch (step_) {
    case Step::Begin:
      if (!stopNews_) return;
      if (isReleased())
        return enter(parameters_.press_after > suture::Duration{0} ? Step::Watch : Step::Done, now);
      return releaseStart(now);
    case Step::Watch:
      if (since < parameters_.press_after || isPressed()) return;
      if (stop_.press()) enter(Step::Pressed, now);
      return;
    case Step::Pressed:
      if (pressesHeard_ > 1 || (pressesHeard_ == 1 && isReleased())) return enter(Step::Done, now);
      if (since < parameters_.release_after) return;
      if (pressesHeard_ == 0) return enter(Step::Done, now);  // the press has not arrived
      if (mayAskAgain(now)) (void)stop_.release(stopNews_->press);
      return;
    case Step::Done: return;
  }
}

void Assistant::enter(Step step, suture::Time now) {
  step_ = step;
  stepped_ = now;
  asked_ = {};
  pressesHeard_ = 0;
}

void Assistant::releaseStart(suture::Time now) {
  const auto isFirst = isOfTheFirstStart();
  if (!isFirst) return;
  if (!*isFirst) return enter(Step::Done, now);
  firstPress_ = stopNews_->press;
  if (mayAskAgain(now)) (void)stop_.release(stopNews_->press);
}

// What was found once counts, because a release makes the arms used before its news are here.
std::optional<bool> Assistant::isOfTheFirstStart() {
  if (!stopNews_->is_start) return false;
  if (firstPress_ == stopNews_->press) return true;
  if (console_.isAbsent()) return true;
  if (use_ == SystemUse::Used) return false;
  if (use_ == SystemUse::Unused && console_.connected()) return true;
  return std::nullopt;
}

bool Assistant::mayAskAgain(suture::Time now) {
  if (now - asked_ < parameters_.patience) return false;
  asked_ = now;
  return true;
}

template <class Contract>
void Assistant::attend(suture::Required<Contract>& one, Waiting& waiting, suture::Time now) {
  if (one.connected() && hasWaited(waiting, now)) waiting.asked = one.enable().has_value();
}

void Assistant::bringUpAgain(suture::Time now) {
  if (!console_.connected() || !isDown_ || !hasWaited(consoleWaits_, now)) return;
  consoleWaits_.asked = console_.bring_up().has_value();
}

bool Assistant::hasWaited(const Waiting& waiting, suture::Time now) const {
  if (!waiting.since || !waiting.lostPower || waiting.asked) return false;
  return now - std::max({*waiting.since, lost_, released_}) >= parameters_.patience;
}

void Assistant::tell(Waiting& waiting, bool waits) const {
  if (waits == waiting.since.has_value()) return;
  waiting = {};
  if (!waits) return;
  const suture::Time now = suture::now();
  waiting.since = now;
  waiting.lostPower = isPressed() || now - lost_ <= kSameCause;
}

}  // namespace robots
