#pragma once
// A provided interface executes here what its clients have sent, or refuses it.

#include <suture/base/errors.h>
#include <suture/base/time.h>
#include <suture/component/channel/channel_list.h>
#include <suture/component/provided/command_clock.h>
#include <suture/component/provided/command_runner.h>
#include <suture/component/provided/interface_clients.h>

namespace suture::rt {
struct CommandRecord;
}

namespace suture {

/// Belongs to the thread that serves the interface.
class CommandDrain {
 public:
  CommandDrain(InterfaceClients& clients, CommandRunner& runner)
      : clients_(clients), runner_(runner) {}
  CommandDrain(const CommandDrain&) = delete;
  CommandDrain& operator=(const CommandDrain&) = delete;

  /// A cycle begins, in which drain() is called for clients.
  void begin();
  /// Executes what `node` has sent up to the cut of its mailbox, which has been fixed. Each
  /// command, its connection and the component are judged when that command is next to run:
  /// handlers may take long, and the process may be stopped at any moment. A handler's exception
  /// passes through, after its caller got Errc::Faulted.
  void drain(ChannelList::Node& node);
  /// In the handler of a queued command: returns how old it was when the clock was last read.
  Duration commandAge() const { return commandAge_; }

 private:
  class Execution;

  void turnAway(Channel& channel, const rt::CommandRecord& record, Errc refusal);
  void run(ChannelList::Node& node, const rt::CommandRecord& record);

  InterfaceClients& clients_;
  CommandRunner& runner_;
  CommandClock clock_;
  bool mayBeLate_ = false;  // handlers may have taken long since the clock was read
  Duration commandAge_{0};
};

}  // namespace suture
