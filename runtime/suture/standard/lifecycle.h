#pragma once
// This is what every component reports of its life, and how others change it.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace suture {

enum class SUTURE_TYPE() ComponentState : std::uint8_t {
  Constructed,
  Configured,
  Running,
  Suspended,  ///< keeps its thread and its connections, and only waits for resume
  Faulted,    ///< a handler or hook threw; the end of this component, not of its process
  Stopped,
};

/// Says that a component has come into a state.
struct SUTURE_TYPE() StateChange {
  ComponentState state = ComponentState::Constructed;
  /// The component threw this, if the state is Faulted; the end of the text may be cut off.
  SUTURE_FIELD(capacity(255)) std::string fault;
  suture::Time stamp;
};

/// Says what became of a request to let the commands of a connection through again.
enum class SUTURE_TYPE() ResumeOutcome : std::uint8_t {
  Resumed,
  Asked,  ///< of a device: it happens when it uses the connection next, unless that is lost then
  NoSuchInterface,  ///< the component requires none of that name
  NotConnected,
  NotAwaiting,   ///< it awaits no operator, so nothing has to be done
  ProviderLost,  ///< or it is suspended or faulted: a connection to it cannot be resumed
};

/// Lifecycle is the provided interface "component" of every component that a manager has. It is
/// served even while the component is suspended or faulted.
class SUTURE_INTERFACE() Lifecycle {
 public:
  virtual ~Lifecycle() = default;

  /// Suspends the component, which does nothing from its next cycle on. Returns false if it is not
  /// running.
  SUTURE_COMMAND() virtual bool suspend() = 0;
  /// Lets the component go on. Returns false if it is not suspended.
  SUTURE_COMMAND() virtual bool resume() = 0;
  SUTURE_COMMAND() virtual ComponentState component_state() const = 0;
  /// Lets the commands of a required interface through again, which await their operator after a
  /// loss or a value that was too old.
  SUTURE_COMMAND()
  virtual ResumeOutcome resume_connection(SUTURE_FIELD(capacity(63))
                                              const std::string& required) = 0;
  /// Reports each transition once, and the last one to a client that subscribes later.
  SUTURE_EVENT(latched()) suture::EventOf<StateChange> state_changed;
};

}  // namespace suture
