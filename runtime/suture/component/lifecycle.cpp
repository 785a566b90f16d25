#include <suture/base/errors.h>
#include <suture/component/lifecycle.h>

namespace suture {
namespace {

using State = ComponentState;

struct Step {
  Transition transition;
  State from, to;
};

constexpr Step kSteps[] = {
    {Transition::Configure, State::Constructed, State::Configured},
    {Transition::Start, State::Configured, State::Running},
    {Transition::Start, State::Stopped, State::Running},
    {Transition::Suspend, State::Running, State::Suspended},
    {Transition::Resume, State::Suspended, State::Running},
    {Transition::Stop, State::Running, State::Stopped},
    {Transition::Stop, State::Suspended, State::Stopped},
    {Transition::Restart, State::Faulted, State::Running},
};

// Returns, for example, "only when it is configured or stopped".
std::string statesBefore(Transition transition) {
  std::string text;
  for (const Step& step : kSteps) {
    if (step.transition != transition) continue;
    text += (text.empty() ? "" : " or ") + std::string(toString(step.from));
  }
  return text;
}

}  // namespace

const char* toString(ComponentState state) {
  switch (state) {
    case State::Constructed: return "constructed";
    case State::Configured: return "configured";
    case State::Running: return "running";
    case State::Suspended: return "suspended";
    case State::Faulted: return "faulted";
    case State::Stopped: return "stopped";
  }
  return "unknown";
}

const char* toString(Transition transition) {
  switch (transition) {
    case Transition::Configure: return "configure";
    case Transition::Start: return "start";
    case Transition::Suspend: return "suspend";
    case Transition::Resume: return "resume";
    case Transition::Stop: return "stop";
    case Transition::Restart: return "restart";
  }
  return "unknown";
}

const ComponentState* after(ComponentState state, Transition transition) {
  for (const Step& step : kSteps) {
    if (step.transition == transition && step.from == state) return &step.to;
  }
  return nullptr;
}

void requireLegal(const std::string& name, ComponentState state, Transition transition) {
  if (after(state, transition)) return;
  const std::string verb = toString(transition);
  throw SetupError("component '" + name + "' was asked to " + verb,
                   std::string("it is ") + toString(state),
                   state == State::Faulted
                       ? "Look at why it has faulted, correct the cause, and create it anew"
                       : "A component can " + verb + " when it is " + statesBefore(transition));
}

}  // namespace suture
