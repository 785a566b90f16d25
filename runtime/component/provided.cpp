#include <suture/component/channel.h>
#include <suture/component/provided.h>

#include <algorithm>
#include <string>
#include <vector>

namespace suture {
namespace {

std::unique_ptr<rt::StateTable> makeLatchedTable(const InterfaceInfo& info) {
  std::vector<std::uint32_t> sizes;
  rt::ColumnSet shared = 0;
  bool any = false;
  for (const EventInfo& event : info.events) {
    shared |= rt::ColumnSet{event.latched && event.sharedPayload} << sizes.size();
    sizes.push_back(event.latched ? event.payloadSize : 0);
    any = any || event.latched;
  }
  constexpr unsigned kRows = 4;
  return any ? std::make_unique<rt::StateTable>(sizes, kRows, shared) : nullptr;
}

// The counters have one writer each.
void increment(std::atomic<std::uint64_t>& counter) {
  counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

}  // namespace

ProvidedBase::ProvidedBase(Component& owner, std::string_view name, const InterfaceInfo& info,
                           void* implementation)
    : name_(name),
      owner_(owner),
      info_(info),
      implementation_(implementation),
      state_(makeStateTable(info)),
      latched_(makeLatchedTable(info)) {
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
  if (!channels_.empty() || state_->demand() != 0) {
    throw SetupError(asked, "somebody uses it already",
                     "Call keepState() in the component's constructor");
  }
  if (options.manual && !owner_.ownsThread()) {
    throw SetupError(asked, "a device, which has no thread to publish rows in",
                     "Make the component a task, or leave 'manual' out");
  }
  constexpr unsigned kMostRows = 1u << 20;
  if (options.rows == 0 || options.rows > kMostRows) {
    throw SetupError(asked, std::to_string(options.rows) + " rows",
                     "Keep 1 to " + std::to_string(kMostRows));
  }
  manual_ = options.manual;
  state_->resize(options.rows);
}

void ProvidedBase::attach(std::shared_ptr<Channel> channel) {
  if (!owner_.ownsThread()) replayLatched(*channel);
  if (owner_.state() == ComponentState::Faulted) channel->status = ChannelStatus::Faulted;
  rt::Doorbell& provider = *channel->ends.provider;
  channels_.add(std::move(channel));
  provider.ring();
}

void ProvidedBase::drain() {
  if (owner_.ownsThread()) channels_.sweep();  // a device may be walking the list in another thread
  channels_.forEach([this](ChannelList::Node& node) {
    greet(node);
    drain(*node.channel);
  });
}

// A device greets when a channel is attached: it has no cycle in which to do it.
void ProvidedBase::greet(ChannelList::Node& node) {
  if (node.greeted || !owner_.ownsThread()) return;
  node.greeted = true;
  replayLatched(*node.channel);
}

void ProvidedBase::drain(Channel& channel) {
  if (!channel.commands.pending()) return;
  channel.commands.fixCut();
  const Time drainStart = now();
  while (const rt::CommandRecord* record = channel.commands.next()) {
    run(channel, *record, drainStart);
  }
}

void ProvidedBase::run(Channel& channel, const rt::CommandRecord& record, Time drainStart) {
  const CommandInfo& command = info_.commands[record.command];
  // Released on every way out, also when the handler throws.
  struct Release {
    Channel& channel;
    Component& owner;
    std::uint16_t command;
    std::uint32_t call;
    bool
        usesCredit;  // a newest-wins command without an answer travels in its cell, not in the ring
    bool answered = false;
    ~Release() {
      channel.commands.pop();
      if (usesCredit) channel.commands.returnCredit(command);
      if (call != 0 && !answered) channel.replyError(call, Errc::Faulted);
      if (call != 0 || channel.wantsRows.load(std::memory_order_relaxed)) {
        owner.ringLater(*channel.ends.client);
      }
    }
  } release{channel, owner_, record.command, record.call, !command.latest || record.call != 0};

  if (command.ttl > Duration{0} && drainStart - record.stamp > command.ttl) {
    increment(channel.commands.counters.late);
    if (record.call != 0) channel.replyError(record.call, Errc::Late);
    release.answered = true;
    return;
  }
  channel.commandAge.record(drainStart - record.stamp);
  increment(channel.commands.counters.executed);
  if (record.call == 0) {
    execute(record.command, record.arguments(), nullptr);
  } else {
    const ResultForm form{command.resultSize, command.sharedResult};
    channel.reply(record.call, form, [&](std::byte* result) {
      return execute(record.command, record.arguments(), result);
    });
    release.answered = true;
  }
}

void ProvidedBase::publishRow() {
  if (!manual_) advance();
}

void ProvidedBase::advance() {
  const rt::ColumnSet demand = state_->demand();
  if (demand == 0) return;
  rt::ColumnSet valid = 0, tooLarge = 0;
  for (std::uint16_t i = 0; i < info_.commands.size(); ++i) {
    const int column = info_.commands[i].column;
    if (column < 0 || (demand >> column & 1) == 0) continue;
    const Errc error = execute(i, nullptr, state_->draft(static_cast<unsigned>(column)));
    (error == Errc{} ? valid : tooLarge) |= rt::ColumnSet{1} << column;
  }
  state_->publish(now(), valid, tooLarge);
  channels_.forEach([this](ChannelList::Node& node) {
    if (node.channel->wantsRows.load(std::memory_order_relaxed)) {
      owner_.ringLater(*node.channel->ends.client);
    }
  });
}

bool ProvidedBase::pending() const {
  bool any = false;
  channels_.forEach([this, &any](ChannelList::Node& node) {
    const bool newcomer = owner_.ownsThread() && !node.greeted;
    any = any || newcomer || node.channel->commands.pending();
  });
  return any;
}

void ProvidedBase::announce(ChannelStatus status) {
  channels_.forEach([status](ChannelList::Node& node) {
    ChannelStatus expected = ChannelStatus::Connected;
    node.channel->status.compare_exchange_strong(expected, status);
    node.channel->ends.client->ring();
  });
}

void ProvidedBase::emit(std::uint16_t event, std::span<const std::byte> payload) {
  const Time stamp = now();
  if (info_.events[event].latched) keepLatched(event, payload);
  channels_.forEach([&](ChannelList::Node& node) {
    Channel& channel = *node.channel;
    if ((channel.subscribed >> event & 1) == 0) return;
    if (owner_.ownsThread() && !node.greeted)
      return;  // joins, with the latched values, at the next cycle
    channel.events.push(event, stamp, payload);
    owner_.ringLater(*channel.ends.client);
  });
}

void ProvidedBase::keepLatched(std::uint16_t event, std::span<const std::byte> payload) {
  // A device may emit from two threads at once. Such events have no order, so either may be the
  // last.
  if (keeping_.test_and_set(std::memory_order_acquire)) return;
  std::copy(payload.begin(), payload.end(), latched_->draft(event));
  if (info_.events[event].sharedPayload) sharedSlotIn(payload.data())->retain();
  latchedSoFar_ |= EventSet{1} << event;
  latched_->publish(now(), latchedSoFar_, 0);
  keeping_.clear(std::memory_order_release);
}

void ProvidedBase::replayLatched(Channel& channel) {
  if (latched_ == nullptr) return;
  for (std::uint16_t i = 0; i < info_.events.size(); ++i) {
    if (!info_.events[i].latched || (channel.subscribed >> i & 1) == 0) continue;
    std::vector<std::byte> payload((info_.events[i].payloadSize + 7) & ~7u);
    const auto stamp = latched_->read(i, payload.data());
    if (!stamp) continue;
    channel.events.push(i, *stamp, std::span(payload).first(info_.events[i].payloadSize));
    if (info_.events[i].sharedPayload) releaseSharedSlot(payload.data());
    owner_.ringLater(*channel.ends.client);
  }
}

}  // namespace suture
