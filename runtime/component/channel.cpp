#include <suture/component/channel.h>
#include <suture/component/provided.h>

#include <algorithm>
#include <vector>

namespace suture {
namespace {

std::vector<rt::CommandLimits> commandLimits(const InterfaceInfo& info) {
  std::vector<rt::CommandLimits> limits;
  for (const CommandInfo& command : info.commands) {
    limits.push_back(
        {command.argumentsSize, command.depth, command.latest, command.sharedArguments});
  }
  return limits;
}

std::vector<rt::EventLimits> eventLimits(const InterfaceInfo& info) {
  std::vector<rt::EventLimits> limits;
  for (const EventInfo& event : info.events) {
    limits.push_back({event.payloadSize, event.depth, event.latest, event.sharedPayload});
  }
  return limits;
}

// Those of a task in this process, which are emitted in its thread.
rt::Producers eventProducers(const Channel::Ends& ends) {
  const bool ofTask = ends.here != nullptr && ends.here->owner().ownsThread();
  return ofTask ? rt::Producers::One : rt::Producers::Any;
}

std::size_t replyBytes(const InterfaceInfo& info) {
  std::uint32_t largest = 0;
  for (const CommandInfo& command : info.commands) largest = std::max(largest, command.resultSize);
  return Channel::kMaxCalls * rt::SpscRing::recordSize(sizeof(ReplyRecord) + largest);
}

}  // namespace

Channel::Channel(const InterfaceInfo& contract, std::string channelName, std::string laneName,
                 Ends bothEnds, std::shared_ptr<rt::StateTable> table, EventSet subscribedEvents)
    : info(contract),
      name(std::move(channelName)),
      lane(std::move(laneName)),
      ends(bothEnds),
      state(std::move(table)),
      offered(contract.commands.size()),
      commands(commandLimits(contract)),
      replies(replyBytes(contract)),
      events(eventLimits(contract), eventProducers(bothEnds)),
      direct(contract.events.size()),
      subscribed_(subscribedEvents),
      joining_(subscribedEvents) {}

void Channel::subscribe(EventSet wanted, EventSet newlyWanted) {
  subscribed_.store(wanted, std::memory_order_release);
  if (newlyWanted != 0) joining_.fetch_or(newlyWanted, std::memory_order_release);
}

EventSet Channel::takeJoining() {
  return joining() ? joining_.exchange(0, std::memory_order_acquire) : 0;
}

void Channel::tell(ChannelStatus news) {
  ChannelStatus present = status.load(std::memory_order_acquire);
  do {
    const bool over = present == ChannelStatus::Lost || present == ChannelStatus::Closed;
    const bool restarted = news == ChannelStatus::Connected;  // the only way out of a fault
    if (over || present == news || (present == ChannelStatus::Faulted && !restarted)) return;
  } while (!status.compare_exchange_weak(present, news));
  if (news == ChannelStatus::Faulted) faults.fetch_add(1, std::memory_order_release);
  ends.client->ring();
}

void Channel::replyError(std::uint32_t call, Errc error) {
  reply(call, {}, [error](std::byte*) { return error; });
}

Channel::~Channel() {
  while (nextReply() != nullptr) popReply();
}

ReplyRecord* Channel::nextReply() {
  return reinterpret_cast<ReplyRecord*>(const_cast<std::byte*>(replies.front()));
}

void Channel::popReply() {
  ReplyRecord* const reply = nextReply();
  if (reply->shared) releaseSharedSlot(reply->result());
  replies.pop();
}

Errc errorOf(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected: return Errc{};
    case ChannelStatus::Lost: return Errc::Lost;
    case ChannelStatus::Faulted: return Errc::Faulted;
    case ChannelStatus::Closed: return Errc::NotConnected;
    case ChannelStatus::Suspended: return Errc::Suspended;
  }
  return Errc::NotConnected;
}

ChannelStatus statusIn(ComponentState state) {
  switch (state) {
    case ComponentState::Suspended: return ChannelStatus::Suspended;
    case ComponentState::Faulted: return ChannelStatus::Faulted;
    default: return ChannelStatus::Connected;
  }
}

std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info) {
  std::vector<std::uint32_t> sizes;
  rt::ColumnSet shared = 0;
  for (const CommandInfo& command : info.commands) {
    if (command.kind != CommandKind::Read) continue;
    shared |= rt::ColumnSet{command.sharedResult} << sizes.size();
    sizes.push_back(command.resultSize);
  }
  return std::make_shared<rt::StateTable>(sizes, rt::StateTable::kDefaultRows, shared);
}

}  // namespace suture
