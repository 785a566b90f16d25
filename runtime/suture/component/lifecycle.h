#pragma once
// The life of a component: its states, and what leads from one to another.

#include <suture/standard/lifecycle.h>

#include <cstdint>
#include <string>

namespace suture {

enum class Transition : std::uint8_t { Configure, Start, Suspend, Resume, Stop, Restart };

/// In words, for people. Any thread; static storage.
const char* toString(ComponentState state);
const char* toString(Transition transition);

/// Where `transition` leads from `state`; null if it is not legal there. Static storage.
const ComponentState* after(ComponentState state, Transition transition);

/// Throws SetupError if `transition` of the component `name`, which is in `state`, is not legal.
void requireLegal(const std::string& name, ComponentState state, Transition transition);

/// Hears of every change of one component's state, in the thread that changes it: the component's
/// own, but for Configured that of the manager.
class StateListener {
 public:
  virtual ~StateListener() = default;
  virtual void stateChanged(ComponentState state) = 0;
};

}  // namespace suture
