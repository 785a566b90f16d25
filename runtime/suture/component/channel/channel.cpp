#include <suture/base/virtual_time.h>
#include <suture/component/channel/call_limit.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/memory_budget.h>
#include <suture/component/provided.h>

#include <algorithm>
#include <cstddef>
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
    limits.push_back(
        {event.payloadSize, event.depth, event.latest, event.sharedPayload, event.latched});
  }
  return limits;
}

// A task in this process emits in its own thread only; others may emit in any.
rt::Producers eventProducers(const Channel::Ends& ends) {
  const bool ofTask = ends.here != nullptr && ends.here->owner().ownsThread();
  return ofTask ? rt::Producers::One : rt::Producers::Any;
}

std::unique_ptr<rt::Histogram> agesUnless(ConnectionEnd other, ConnectionEnd components) {
  return components == other ? nullptr : std::make_unique<rt::Histogram>();
}

std::size_t replyBytes(const InterfaceInfo& info) {
  const CallLimit limit = callLimitOf(info);
  return limit.calls * rt::SpscRing::recordSize(sizeof(ReplyRecord) + limit.largestResult);
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
      words_(memory.make<Words>()),
      commands(commandLimits(contract), memory),
      replies(replyBytes(contract), memory),
      events(eventLimits(contract), eventProducers(ends), memory),
      counts(std::make_shared<ChannelCounts>(commands.sharedCounters(), events.sharedCounters(),
                                             foreign)),
      direct(contract.events.size()),
      wantsRows(words_->wantsRows),
      readAge(agesUnless(ConnectionEnd::Provider, ends.components)),
      commandAge(agesUnless(ConnectionEnd::Client, ends.components)),
      lease(ends.peer, ends.silence),
      untaken(words_->untaken) {
  if (!memory.fresh()) return;
  words_->subscribed.store(subscribedEvents, std::memory_order_relaxed);
  words_->joining.store(subscribedEvents, std::memory_order_relaxed);
}

std::size_t Channel::bytesFor(const InterfaceInfo& info) {
  Arena memory = Arena::measuring();
  memory.take(sizeof(Words));
  const rt::Mailbox commands(commandLimits(info), memory);
  const rt::SpscRing replies(replyBytes(info), memory);
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

// A provider in this process was judged when it produced the value; the build of another process
// may admit more than this one, and no thread before the reader's looks at what it sent.
bool Channel::admitsCopy(const CommandInfo& command, const std::byte* result) {
  if (ends.here != nullptr || command.admitsResult(result)) return true;
  return admitsResult(command, result);  // once more, to note where
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

void Channel::subscribe(EventSet wanted, EventSet newlyWanted) {
  words_->subscribed.store(wanted, std::memory_order_release);
  if (newlyWanted != 0) words_->joining.fetch_or(newlyWanted, std::memory_order_release);
}

EventSet Channel::takeJoining() {
  return joining() ? words_->joining.exchange(0, std::memory_order_acquire) : 0;
}

void Channel::tell(ChannelStatus news) {
  ChannelStatus present = status.load(std::memory_order_acquire);
  do {
    const bool restarted = news == ChannelStatus::Connected;  // the only way out of a fault
    const bool rests = present == ChannelStatus::Faulted && !restarted;
    if (isOver(present) || present == news || rests) return;
  } while (!status.compare_exchange_weak(present, news));
  noteStatus(news);
  if (news == ChannelStatus::Faulted) faults.fetch_add(1, std::memory_order_release);
  ends.client->ring();
  if (ends.watcher != nullptr) ends.watcher->ring();
}

void Channel::noteStatus(ChannelStatus news) const {
  VirtualTime* const time = virtualTime();
  if (time == nullptr) return;
  time->note(VirtualTime::Kind::Status, name().c_str(), lane.c_str(),
             static_cast<std::uint64_t>(news));
}

Errc Channel::begin(bool looksAtClock) {
  if (foreign && words_->cut.isUp(std::memory_order_seq_cst)) return Errc::Lost;
  if (looksAtClock && lease.lapsed()) tell(ChannelStatus::Lapsed);
  const ChannelStatus present = status.load(std::memory_order_acquire);
  return isOver(present) ? errorOf(present) : Errc{};
}

ResumeOutcome Channel::resume() {
  if (terms.watch == nullptr || !terms.watch->awaitsOperator) return ResumeOutcome::NotAwaiting;
  if (errorOf(status.load(std::memory_order_acquire)) != Errc{}) return ResumeOutcome::ProviderLost;
  terms.watch->awaitsOperator = false;
  return ResumeOutcome::Resumed;
}

void Channel::replyError(std::uint32_t call, Errc error) {
  reply(call, {}, [error](std::byte*) { return error; });
}

// Releases the answers that nobody took; in foreign memory, no result owns memory.
Channel::~Channel() {
  while (!foreign && nextReply() != nullptr) popReply();
}

ReplyRecord* Channel::nextReply() {
  for (;;) {
    std::byte* const memory = const_cast<std::byte*>(replies.front());
    if (memory == nullptr || !foreign) return reinterpret_cast<ReplyRecord*>(memory);
    if (replies.frontSize() >= sizeof(ReplyRecord)) return makePossible(memory);
    replies.pop();
  }
}

// The peer controls this memory: never release a pointer that it chose, and clamp its stamp.
ReplyRecord* Channel::makePossible(std::byte* memory) {
  memory[offsetof(ReplyRecord, shared)] = std::byte{0};
  auto* const reply = reinterpret_cast<ReplyRecord*>(memory);
  reply->stamp = std::clamp(reply->stamp, Time{}, now());
  return reply;
}

void Channel::popReply() {
  ReplyRecord* const reply = nextReply();
  if (reply->shared) releaseSharedSlot(reply->result());
  replies.pop();
}

bool isOver(ChannelStatus status) {
  return status == ChannelStatus::Lost || status == ChannelStatus::Closed ||
         status == ChannelStatus::Lapsed;
}

Errc errorOf(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected: return Errc{};
    case ChannelStatus::Lost:
    case ChannelStatus::Lapsed: return Errc::Lost;
    case ChannelStatus::Faulted: return Errc::Faulted;
    case ChannelStatus::Closed: return Errc::NotConnected;
    case ChannelStatus::Suspended: return Errc::Suspended;
  }
  return Errc::NotConnected;
}

Errc endOfCalls(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected:
    case ChannelStatus::Suspended: return Errc{};
    case ChannelStatus::Faulted: return Errc::Faulted;
    default: return Errc::OutcomeUnknown;
  }
}

ChannelStatus statusIn(ComponentState state) {
  switch (state) {
    case ComponentState::Suspended:
    case ComponentState::Stopped: return ChannelStatus::Suspended;
    case ComponentState::Faulted: return ChannelStatus::Faulted;
    default: return ChannelStatus::Connected;
  }
}

std::shared_ptr<rt::StateTable> makeStateTable(const InterfaceInfo& info,
                                               rt::StateTable::Readers readers, unsigned rows) {
  std::vector<std::uint32_t> sizes;
  rt::ColumnSet shared = 0;
  for (const CommandInfo& command : info.commands) {
    if (command.kind != CommandKind::Read) continue;
    shared |= rt::ColumnSet{command.sharedResult} << sizes.size();
    sizes.push_back(command.resultSize);
  }
  if (shared != 0) readers = rt::StateTable::Readers::Here;  // pointers mean nothing elsewhere
  if (rows == 0) rows = rowsOf(sizes);
  return std::make_shared<rt::StateTable>(sizes, rows, shared, readers);
}

}  // namespace suture
