#include "assistant/assistant.h"

namespace robots {

Assistant::Assistant(const AssistantParameters& parameters)
    : PeriodicTask({.period = parameters.period}), parameters_(parameters) {
  stop_.on().stop([this](const StopNews& news) { pressed_ = news.pressed; });
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
  if (pressed_) return;
  attend(left_, leftWaits_, now);
  attend(right_, rightWaits_, now);
  attend(guidance_, guidanceWaits_, now);
}

void Assistant::followScript(suture::Time now) {
  const suture::Duration since = now - stepped_;
  const bool presses = parameters_.press_after > suture::Duration{0};
  Step next = step_;
  switch (step_) {
    case Step::Begin:
      if (stop_.release()) next = presses ? Step::Watch : Step::Done;
      break;
    case Step::Watch:
      if (since >= parameters_.press_after && stop_.press()) next = Step::Pressed;
      break;
    case Step::Pressed:
      if (since >= parameters_.release_after && stop_.release()) next = Step::Done;
      break;
    case Step::Done: break;
  }
  if (next != step_) stepped_ = now;
  step_ = next;
}

template <class Contract>
void Assistant::attend(suture::Required<Contract>& one, Waiting& waiting, suture::Time now) {
  if (!waiting || !one.connected() || now - *waiting < parameters_.patience) return;
  if (one.enable()) waiting = now;
}

void Assistant::tell(Waiting& waiting, bool waits) {
  waiting = waits ? Waiting(suture::now()) : std::nullopt;
}

}  // namespace robots
