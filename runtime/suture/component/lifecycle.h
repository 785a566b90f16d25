#pragma once
// This describes the life of a component: its states, and what leads from one to another.

#include <suture/standard/lifecycle.h>

#include <cstdint>
#include <string>

namespace suture {

enum class Transition : std::uint8_t { Configure, Start, Suspend, Resume, Stop, Restart };

/// Any thread. Returns words for people, in static storage.
const char* toString(ComponentState state);
const char* toString(Transition transition);

/// Any thread. Returns where `transition` leads from `state`, in static storage, or null if it is
/// not legal there.
const ComponentState* after(ComponentState state, Transition transition);

/// Any thread. Throws SetupError if `transition` of the component `name`, which is in `state`, is
/// not legal.
void requireLegal(const std::string& name, ComponentState state, Transition transition);

/// Hears of every change of one component's state, in the thread that changes it: the component's
/// own, but for Configured the manager's.
class StateListener {
 public:
  virtual ~StateListener() = default;
  virtual void stateChanged(ComponentState state) = 0;
};

}  // namespace suture
