#include <suture/base/virtual_time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/credit.h>
#include <suture/component/component.h>
#include <suture/component/provided/command_drain.h>
#include <suture/rt/counter.h>

#include <utility>

namespace suture {
namespace {

/// Rings a client that had found no room, at the end of a drain, also when a handler throws. If the
/// client has sent more meanwhile, the next drain rings it: else it would be woken again and again
/// for a few places.
struct RoomNotice {
  Channel& channel;
  Component& owner;

  ~RoomNotice() {
    rt::Mailbox& commands = channel.commands;
    if (commands.pending() || !commands.roomAwaited().take(std::memory_order_acq_rel)) return;
    owner.ringLater(*channel.ends.client);
  }
};

// The clock takes as long as a fast handler, so in a long drain it is not read for each command.
bool looksAtClock(unsigned turn) {
  constexpr unsigned kEach = 16, kSeldom = 64;
  return turn < kEach || turn % kSeldom == 0;
}

}  // namespace

/// Holds the execution of one command. Its destructor ends it on every path, also when the handler
/// throws: the command's room is free again, and a caller that waits gets an answer.
class CommandDrain::Execution {
 public:
  Execution(Channel& channel, Component& owner, const rt::CommandRecord& record)
      : outcome(&channel.commands.counters.failed),
        channel_(channel),
        owner_(owner),
        command_(record.command),
        call_(record.call) {}
  Execution(const Execution&) = delete;
  Execution& operator=(const Execution&) = delete;
  ~Execution() {
    if (owner_.ownsThread()) owner_.caller_ = nullptr;
    release();
    if (call_ != 0 && !answered) channel_.provider.replyError(call_, error);
    if (channel_.provider.rowsAreWanted()) {  // the client also learns of what has been taken
      owner_.ringLater(*channel_.ends.client);
    } else if (call_ != 0) {
      owner_.ringForArrival(channel_);
    }
  }

  /// Notes the caller, except for a device, whose commands may run in several threads at once.
  void begin(const ConnectedClient& client) {
    if (owner_.ownsThread()) owner_.caller_ = &client;
  }

  /// Frees the place of a command that has been executed, before a client can see the answer.
  void release() {
    if (std::exchange(released_, true)) return;
    rt::increment(*outcome);
    channel_.commands.pop();
    if (usesCredit(channel_.info.commands[command_], call_)) {
      channel_.commands.returnCredit(command_);
    }
  }

  /// Points to the counter for the outcome of the command.
  std::atomic<std::uint64_t>* outcome;
  bool answered = false;
  Errc error = Errc::Faulted;  ///< sent at the end, unless an answer was sent before

 private:
  Channel& channel_;
  Component& owner_;
  const std::uint16_t command_;
  const std::uint32_t call_;
  bool released_ = false;
};

void CommandDrain::begin() {
  clock_.begin();
  mayBeLate_ = false;
}

void CommandDrain::drain(ChannelList::Node& node) {
  Channel& channel = *node.channel;
  Component& owner = clients_.owner();
  if (std::exchange(mayBeLate_, true)) clock_.look();
  const Time resumed = clients_.servesInEveryState() ? Time{} : owner.resumed();
  const RoomNotice notice{channel, owner};
  // A client that shares memory tells of a loss there.
  const bool onlyClockTells = !channel.foreign && channel.provider.lease.limited();
  for (unsigned turn = 0; const rt::CommandRecord* record = channel.commands.next(); ++turn) {
    const bool hasTtl = clients_.info().commands[record->command].ttl > Duration{0};
    const bool looks = onlyClockTells || hasTtl || looksAtClock(turn);
    if (looks && turn > 0) clock_.look();
    const Errc over = channel.provider.begin(looks ? &clock_.present() : nullptr);
    if (over != Errc{}) {
      turnAway(channel, *record, over);
    } else if (const Errc refused = clients_.refusal(); refused != Errc{}) {
      turnAway(channel, *record, refused);
    } else if (record->stamp < resumed) {
      turnAway(channel, *record, Errc::Suspended);
    } else {
      run(node, *record);
    }
  }
}

// What was sent to a suspended component must not move anything after it is resumed.
void CommandDrain::turnAway(Channel& channel, const rt::CommandRecord& record, Errc refusal) {
  Execution execution(channel, clients_.owner(), record);
  execution.error = refusal;
  execution.outcome = &channel.commands.counters.refused;
}

void CommandDrain::run(ChannelList::Node& node, const rt::CommandRecord& record) {
  Channel& channel = *node.channel;
  const CommandInfo& command = clients_.info().commands[record.command];
  Execution execution(channel, clients_.owner(), record);
  channel.countReceived(rt::SpscRing::recordSize(sizeof(record) + command.argumentsSize));
  commandAge_ = clock_.age(record.stamp);
  if (command.ttl > Duration{0} && commandAge_ > command.ttl) {
    execution.outcome = &channel.commands.counters.late;
    execution.error = Errc::Late;
    return;
  }
  if (record.call != 0 && !channel.provider.claim(record.call)) {
    execution.outcome = &channel.commands.counters.cancelled;
    execution.error = Errc::Cancelled;
    return;
  }
  // Check the copy of foreign arguments; those of other lanes were checked before they came here.
  if (channel.foreign && !channel.admits(command, record.arguments())) {
    execution.outcome = &channel.commands.counters.refused;
    execution.error = Errc::Invalid;
    return;
  }
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->note(VirtualTime::Kind::Execute, clients_.name().c_str(), command.name, record.sequence);
  }
  channel.provider.commandAge->record(commandAge_);
  execution.begin(node.client);
  if (record.call == 0) {
    runner_.execute(record.command, record.arguments(), nullptr);
    execution.outcome = &channel.commands.counters.executed;
  } else {
    const ResultForm form{command.resultSize, command.sharedResult, record.command};
    channel.provider.reply(record.call, form, [&](std::byte* result) {
      const Errc error =
          produce(runner_, clients_, record.command, record.arguments(), result, &channel);
      execution.outcome = &channel.commands.counters.executed;
      execution.release();
      return error;
    });
    execution.answered = true;
  }
}

}  // namespace suture
