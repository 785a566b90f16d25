#include <suture/base/virtual_time.h>
#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/memory_budget.h>
#include <suture/component/provided.h>

#include <vector>

namespace suture {
namespace {

std::vector<rt::CommandLimits> commandLimits(const InterfaceInfo& info) {
  std::vector<rt::CommandLimits> limits;
  for (const CommandInfo& command : info.commands) {
    limits.push_back({command.argumentsSize, command.depth, command.latest, command.sharedArguments,
                      command.argumentsLevels});
  }
  return limits;
}

std::vector<rt::EventLimits> eventLimits(const InterfaceInfo& info) {
  std::vector<rt::EventLimits> limits;
  for (const EventInfo& event : info.events) {
    limits.push_back({event.payloadSize, event.depth, event.latest, event.sharedPayload,
                      event.latched, event.payloadLevels});
  }
  return limits;
}

// A task in this process emits only in its own thread; other providers may emit in any.
rt::Producers eventProducers(const Channel::Ends& ends) {
  const bool ofTask = ends.here != nullptr && ends.here->owner().ownsThread();
  return ofTask ? rt::Producers::One : rt::Producers::Any;
}

rt::SpscRing replyRing(const InterfaceInfo& info, Arena& memory) {
  const CallLimit limit = callLimitOf(info);
  const std::size_t largest = sizeof(ReplyRecord) + limit.largestResult;
  return {limit.calls * rt::SpscRing::recordSize(largest), largest, memory};
}

unsigned rowsOf(const std::vector<std::uint32_t>& sizes) {
  return fewerOfLarge(rt::StateTable::kDefaultRows, 4,
                      [&](unsigned rows) { return rt::StateTable::bytesFor(sizes, rows); });
}

}  // namespace

Channel::Channel(const InterfaceInfo& contract, Terms agreed, std::string laneName, Ends bothEnds,
                 std::shared_ptr<rt::StateTable> table, EventSet subscribedEvents, Arena memory)
    : info(contract),
      terms(std::move(agreed)),
      lane(std::move(laneName)),
      ends(std::move(bothEnds)),
      state(std::move(table)),
      foreign(memory.foreign()),
      words_(memory.make<ChannelWords>()),
      commands(commandLimits(contract), memory),
      replies(replyRing(contract, memory)),
      events(eventLimits(contract), eventProducers(ends), memory),
      counts(std::make_shared<ChannelCounts>(commands.sharedCounters(), events.sharedCounters(),
                                             foreign)),
      direct(contract.events.size()),
      client(*this, *words_, ends.components != ConnectionEnd::Provider),
      provider(*this, *words_, Lease(ends.peer, ends.silence),
               ends.components != ConnectionEnd::Client) {
  if (!memory.fresh()) return;
  words_->subscribed.store(subscribedEvents, std::memory_order_relaxed);
  words_->joining.store(subscribedEvents, std::memory_order_relaxed);
}

std::size_t Channel::bytesFor(const InterfaceInfo& info) {
  Arena memory = Arena::measuring();
  memory.take(sizeof(ChannelWords));
  const rt::Mailbox commands(commandLimits(info), memory);
  const rt::SpscRing replies = replyRing(info, memory);
  const rt::EventQueue events(eventLimits(info), rt::Producers::Any, memory);
  return memory.used();
}

bool Channel::admits(const CommandInfo& command, const std::byte* arguments) {
  FieldPath path;
  if (command.admits(arguments, &path)) return true;
  return lastInvalid.note(path), false;
}

bool Channel::admitsResult(const CommandInfo& command, const std::byte* result) {
  FieldPath path;
  if (command.admitsResult(result, &path)) return true;
  return lastInvalid.note(path), false;
}

// A provider in this process was checked when it produced the value. The build of another process
// may admit more than this one, and no thread before the reader's checks what it sent.
bool Channel::admitsCopy(const CommandInfo& command, const std::byte* result) {
  if (ends.here != nullptr || command.admitsResult(result)) return true;
  return admitsResult(command, result);  // checks again, to note which part is invalid
}

bool Channel::admits(const EventInfo& event, const std::byte* payload) {
  FieldPath path;
  if (event.admits(payload, &path)) return true;
  return lastInvalid.note(path), false;
}

Duration Channel::clockError() const {
  if (ends.peer == nullptr) return Duration{0};
  const Duration compared = ends.peer->clockError.load(std::memory_order_relaxed);
  return compared == Duration{0} ? compared : compared + clockDrift(ends.silence);
}

void Channel::tell(ChannelStatus news) {
  ChannelStatus present = status.load(std::memory_order_acquire);
  do {
    const bool endsFault = news == ChannelStatus::Connected || isOver(news);
    const bool rests = present == ChannelStatus::Faulted && !endsFault;
    if (isOver(present) || present == news || rests) return;
  } while (!status.compare_exchange_weak(present, news));
  noteStatus(news);
  if (news == ChannelStatus::Faulted) faults.fetch_add(1, std::memory_order_release);
  ends.client->ring();
  if (ends.watcher != nullptr) ends.watcher->ring();
}

void Channel::noteStatus(ChannelStatus news) {
  statusSince.store(now(), std::memory_order_relaxed);
  VirtualTime* const time = virtualTime();
  if (time == nullptr) return;
  time->note(VirtualTime::Kind::Status, name().c_str(), lane.c_str(),
             static_cast<std::uint64_t>(news));
}

// Releases the answers that were not taken; in foreign memory, no result owns memory.
Channel::~Channel() {
  while (!foreign && client.nextReply() != nullptr) client.popReply();
}

std::vector<BoundedLevels> columnLevels(const InterfaceInfo& info) {
  std::vector<BoundedLevels> levels;
  for (const CommandInfo& command : info.commands) {
    if (command.kind == CommandKind::Read) levels.push_back(command.resultLevels);
  }
  return levels;
}

std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info,
                                               rt::StateTable::Readers readers, unsigned rows) {
  std::vector<std::uint32_t> sizes;
  const std::vector<BoundedLevels> levels = columnLevels(info);
  rt::ColumnSet shared = 0;
  for (const CommandInfo& command : info.commands) {
    if (command.kind != CommandKind::Read) continue;
    shared |= rt::ColumnSet{command.sharedResult} << sizes.size();
    sizes.push_back(command.resultSize);
  }
  if (shared != 0) readers = rt::StateTable::Readers::Here;  // pointers mean nothing elsewhere
  if (rows == 0) rows = rowsOf(sizes);
  return std::make_shared<rt::StateTable>(sizes, rows, shared, readers, levels);
}

}  // namespace suture
