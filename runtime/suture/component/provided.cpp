#include <suture/base/virtual_time.h>
#include <suture/base/words.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/credit.h>
#include <suture/component/latched.h>
#include <suture/component/provided.h>
#include <suture/rt/counter.h>

#include <algorithm>
#include <string>
#include <vector>

namespace suture {
namespace {

std::size_t payloadWords(const InterfaceInfo& info) {
  std::size_t size = 0;
  for (const EventInfo& event : info.events) size = std::max<std::size_t>(size, event.payloadSize);
  return wordsFor(size);
}

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
class ProvidedBase::Execution {
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

ProvidedBase::ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
                           void* implementation)
    : name_(name),
      owner_(owner),
      info_(info),
      implementation_(implementation),
      channels_(owner.ownsThread() ? ChannelList::Walkers::Owner : ChannelList::Walkers::Any),
      replayed_(payloadWords(info)) {
  for (const EventInfo& event : info.events) {
    latched_.push_back(event.latched ? std::make_unique<Latched>(event) : nullptr);
  }
  refuseUnbounded(info, owner.ownsThread());
  owner.provided_.push_back(this);
}

ProvidedBase::~ProvidedBase() = default;

void* ProvidedBase::implementation(const InterfaceInfo& contract) const {
  void* pointer = implementation_;
  for (const InterfaceInfo* one = &info_; one != &contract && one->base != nullptr;
       one = &one->base()) {
    pointer = one->toBase(pointer);
  }
  return pointer;
}

void ProvidedBase::keepState(const StateOptions& options) {
  const std::string asked = "the state table of '" + name_ + "'";
  if (!channels_.empty() || demand() != 0) {
    throw SetupError(asked, "somebody uses it already",
                     "Call keepState() in the component's constructor");
  }
  if (options.manual && !owner_.ownsThread()) {
    throw SetupError(asked, "a device, which has no thread to publish rows in",
                     "Make the component a task, or leave 'manual' out");
  }
  if (options.rows < 2 || options.rows > StateOptions::kMostRows) {  // one is mostly being written
    throw SetupError(asked, std::to_string(options.rows) + " rows",
                     "Keep 2 to " + std::to_string(StateOptions::kMostRows));
  }
  options_ = options;
  if (rt::StateTable* const table = made_.load(std::memory_order_acquire); table != nullptr) {
    table->resize(options.rows);
  }
}

const std::shared_ptr<rt::StateTable>& ProvidedBase::state() {
  std::call_once(stateMade_, [this] {
    state_ = makeStateTable(info_, rt::StateTable::Readers::Elsewhere, options_.rows);
    made_.store(state_.get(), std::memory_order_release);
  });
  return state_;
}

rt::ColumnSet ProvidedBase::demand() const {
  const rt::StateTable* const table = made_.load(std::memory_order_acquire);
  return table == nullptr ? 0 : table->demand();
}

void ProvidedBase::attach(std::shared_ptr<Channel> channel) {
  sweep();
  channels_.add(channel);
  greetLocal(*channel);
  if (!everyState_) tellState(*channel);
  channel->ends.provider->ring();
}

void ProvidedBase::sweep() {
  if (!owner_.ownsThread()) channels_.sweep();
}

// Repeats until the state stays, because a thread that announces a change may not have seen the
// channel yet.
void ProvidedBase::tellState(Channel& channel) const {
  ComponentState told;
  do {
    told = owner_.state();
    channel.tell(statusIn(told));
  } while (owner_.state() != told);
}

bool ProvidedBase::inService() const {
  return everyState_ || statusIn(owner_.state()) == ChannelStatus::Connected;
}

bool ProvidedBase::hears() const {
  return owner_.state() == ComponentState::Running && !owner_.ending();
}

// Skips local clients of a device, which come and go in their own threads.
bool ProvidedBase::isNews(const ChannelList::Node& node) {
  if (node.channel->ends.device != nullptr) return false;
  const bool over = isOver(node.channel->status.load(std::memory_order_seq_cst));
  return over == node.known.load(std::memory_order_relaxed);
}

// Marks a client as known before it reads the status, so that a thread that removes closed channels
// meanwhile leaves those that the component knows of.
void ProvidedBase::tellOf(ChannelList::Node& node) {
  if (!isNews(node)) return;
  const bool known = node.known.exchange(true, std::memory_order_seq_cst);
  const ChannelStatus status = node.channel->status.load(std::memory_order_seq_cst);
  const bool over = isOver(status);
  if (over) node.known.store(false, std::memory_order_seq_cst);
  if (known != over) return;  // the client has come and gone
  const ClientNews end = status == ChannelStatus::Lapsed ? ClientNews::Silent : ClientNews::Closed;
  owner_.onClient(*this, node.client, over ? end : ClientNews::Connected);
}

void ProvidedBase::drain() {
  if (hears()) channels_.forEach([this](ChannelList::Node& node) { tellOf(node); });
  if (owner_.ownsThread() && channels_.unlinkClosed()) {
    owner_.ringNow();  // a bell that is due may go with its channel
    channels_.letGo();
  }
  clock_.begin();
  bool mayBeLate = false;  // handlers may have taken long since the clock was read
  channels_.forEach([this, &mayBeLate](ChannelList::Node& node) {
    Channel& channel = *node.channel;
    if (channel.ends.asked != nullptr) {
      channel.state->askAll(channel.ends.asked->load(std::memory_order_acquire));
    }
    const bool any = channel.commands.pending();
    // Fix the cut first, so that a command's events reach those who subscribed before they sent it.
    if (any) channel.commands.fixCut();
    greet(node);
    if (!any) return;
    if (mayBeLate) clock_.look();
    drain(node);
    mayBeLate = true;
  });
}

// Skips local clients of a device, which greet themselves because it has no cycle.
void ProvidedBase::greet(ChannelList::Node& node) {
  Channel& channel = *node.channel;
  if (channel.ends.device != nullptr) return;
  const EventSet joining = channel.provider.takeJoining();
  node.served = channel.subscribed();
  node.direct = channel.direct.events();
  if (joining != 0) replay(channel, joining & node.served, replayed_);
}

void ProvidedBase::greetLocal(Channel& channel) {
  if (channel.ends.device != this) return;
  const EventSet joining = channel.provider.takeJoining() & channel.subscribed();
  if (joining == 0) return;
  std::vector<std::uint64_t> memory(replayed_.size());
  replay(channel, joining, memory);
}

Errc ProvidedBase::refusal() const {
  if (owner_.ending()) return Errc::Lost;
  return inService() ? Errc{} : errorOf(statusIn(owner_.state()));
}

// Checks a command, its connection and this component when the command is next to run: handlers may
// take long, and the process may be stopped at any moment.
void ProvidedBase::drain(ChannelList::Node& node) {
  Channel& channel = *node.channel;
  const Time resumed = everyState_ ? Time{} : owner_.resumed();
  const RoomNotice notice{channel, owner_};
  // A client that shares memory tells of a loss there.
  const bool onlyClockTells = !channel.foreign && channel.provider.lease.limited();
  for (unsigned turn = 0; const rt::CommandRecord* record = channel.commands.next(); ++turn) {
    const bool hasTtl = info_.commands[record->command].ttl > Duration{0};
    const bool looks = onlyClockTells || hasTtl || looksAtClock(turn);
    if (looks && turn > 0) clock_.look();
    const Errc over = channel.provider.begin(looks ? &clock_.present() : nullptr);
    if (over != Errc{}) {
      turnAway(channel, *record, over);
    } else if (const Errc refused = refusal(); refused != Errc{}) {
      turnAway(channel, *record, refused);
    } else if (record->stamp < resumed) {
      turnAway(channel, *record, Errc::Suspended);
    } else {
      run(node, *record);
    }
  }
}

// What was sent to a suspended component must not move anything after it is resumed.
void ProvidedBase::turnAway(Channel& channel, const rt::CommandRecord& record, Errc refusal) {
  Execution execution(channel, owner_, record);
  execution.error = refusal;
  execution.outcome = &channel.commands.counters.refused;
}

void ProvidedBase::run(ChannelList::Node& node, const rt::CommandRecord& record) {
  Channel& channel = *node.channel;
  const CommandInfo& command = info_.commands[record.command];
  Execution execution(channel, owner_, record);
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
    time->note(VirtualTime::Kind::Execute, name_.c_str(), command.name, record.sequence);
  }
  channel.provider.commandAge->record(commandAge_);
  execution.begin(node.client);
  if (record.call == 0) {
    execute(record.command, record.arguments(), nullptr);
    execution.outcome = &channel.commands.counters.executed;
  } else {
    const ResultForm form{command.resultSize, command.sharedResult, record.command};
    channel.provider.reply(record.call, form, [&](std::byte* result) {
      const Errc error = produce(record.command, record.arguments(), result, &channel);
      execution.outcome = &channel.commands.counters.executed;
      execution.release();
      return error;
    });
    execution.answered = true;
  }
}

Errc ProvidedBase::produce(std::uint16_t command, const std::byte* arguments, std::byte* result,
                           Channel* asker) {
  const Errc error = execute(command, arguments, result);
  FieldPath path;
  if (error != Errc{} || info_.commands[command].admitsResult(result, &path)) return error;
  noteInvalid(path, asker);
  return Errc::Invalid;
}

void ProvidedBase::noteInvalid(const FieldPath& path, Channel* asker) {
  lastInvalid_.note(path);
  if (asker != nullptr) return asker->lastInvalid.note(path);
  channels_.forEach([&path](ChannelList::Node& node) { node.channel->lastInvalid.note(path); });
}

void ProvidedBase::publishRow() {
  if (!options_.manual) advance();
}

void ProvidedBase::advance() {
  const rt::ColumnSet wanted = demand();
  if (wanted == 0) return;
  rt::StateTable& table = *made_.load(std::memory_order_relaxed);
  rt::RowColumns columns;
  for (std::uint16_t i = 0; i < info_.commands.size(); ++i) {
    const int column = info_.commands[i].column;
    if (column < 0 || (wanted >> column & 1) == 0) continue;
    const auto number = static_cast<unsigned>(column);
    columns.enter(number, produce(i, nullptr, table.draft(number), nullptr));
  }
  table.publish(now(), columns);
  channels_.forEach([this](ChannelList::Node& node) {
    if (node.channel->provider.rowsAreWanted()) {
      owner_.ringLater(*node.channel->ends.client);
    }
  });
}

bool ProvidedBase::pendingFrom(std::string_view component) const {
  bool any = false;
  channels_.forEach([&any, component](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    any = any ||
          (channel.commands.pending() && Channel::componentOf(channel.clientName()) == component);
  });
  return any;
}

bool ProvidedBase::pending() const {
  bool any = false;
  channels_.forEach([&any, hears = hears()](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    const bool newcomer = channel.provider.joining() && channel.ends.device == nullptr;
    any = any || newcomer || channel.commands.pending() || (hears && isNews(node));
  });
  return any;
}

void ProvidedBase::announce(ChannelStatus status) {
  if (everyState_ && status != ChannelStatus::Lost) return;
  channels_.forEach([status](ChannelList::Node& node) { node.channel->tell(status); });
}

}  // namespace suture
