#pragma once
// What every component tells of its life, and how others change it.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <cstdint>
#include <string>

namespace suture {

enum class SUTURE_TYPE() ComponentState : std::uint8_t {
  Constructed,
  Configured,
  Running,
  Suspended,  ///< keeps its thread and its connections, and does nothing but wait for resume
  Faulted,    ///< a handler or hook threw; the end of this component, not of its process
  Stopped,
};

/// A component has come into a state.
struct SUTURE_TYPE() StateChange {
  ComponentState state = ComponentState::Constructed;
  /// What was thrown, if the state is Faulted; its end may be cut off.
  SUTURE_FIELD(capacity(255)) std::string fault;
  suture::Time stamp;
};

/// What has become of a request to let the commands of a connection through again.
enum class SUTURE_TYPE() ResumeOutcome : std::uint8_t {
  Resumed,
  Asked,            ///< of a device: done when it uses the connection next, unless it is lost then
  NoSuchInterface,  ///< the component requires none of that name
  NotConnected,
  NotAwaiting,   ///< it awaits no operator: nothing has to be done
  ProviderLost,  ///< or suspended, or faulted: nobody resumes what is not there, or has just gone
};

/// The provided interface "component" of every component that a manager has. It is served also
/// while the component is suspended or faulted.
class SUTURE_INTERFACE() Lifecycle {
 public:
  virtual ~Lifecycle() = default;

  /// Lets the component do nothing from its next cycle on. False: it is not running.
  SUTURE_COMMAND() virtual bool suspend() = 0;
  /// Lets it go on. False: it is not suspended.
  SUTURE_COMMAND() virtual bool resume() = 0;
  SUTURE_COMMAND() virtual ComponentState component_state() const = 0;
  /// Lets the commands of a required interface through again, which await their operator after a
  /// loss or a value that was too old.
  SUTURE_COMMAND()
  virtual ResumeOutcome resume_connection(SUTURE_FIELD(capacity(63))
                                              const std::string& required) = 0;
  /// Once for each transition; whoever subscribes later gets the last.
  SUTURE_EVENT(latched()) suture::EventOf<StateChange> state_changed;
};

}  // namespace suture
