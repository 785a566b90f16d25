#include <suture/base/slots/shared_slot.h>
#include <suture/base/slots/used_parts.h>
#include <suture/component/channel/channel.h>
#include <suture/rt/queue/record_copy.h>

#include <algorithm>
#include <cstddef>

namespace suture {
namespace {

// Looks only at its copy of the record, since the original may change. If that cannot be a result
// of its command, everything is copied.
void copyForeign(const InterfaceInfo& info, std::byte* to, const std::byte* from,
                 std::size_t size) {
  const auto record = rt::copyHead<ReplyRecord>(to, from, size);
  if (size <= sizeof(record)) return;
  const std::size_t rest = size - sizeof(record);
  const bool possible =
      record.command < info.commands.size() && info.commands[record.command].resultSize == rest;
  copyUsed(to + sizeof(record), from + sizeof(record), rest,
           possible ? info.commands[record.command].resultLevels : BoundedLevels{});
}

}  // namespace

ChannelClient::ChannelClient(Channel& channel, ChannelWords& words, bool keepsAges)
    : readAge(keepsAges ? std::make_unique<rt::Histogram>() : nullptr),
      channel_(channel),
      words_(words) {}

void ChannelClient::subscribe(EventSet wanted, EventSet newlyWanted) {
  words_.subscribed.store(wanted, std::memory_order_release);
  if (newlyWanted != 0) words_.joining.fetch_or(newlyWanted, std::memory_order_release);
}

void ChannelClient::close() {
  cut();
  channel_.status = ChannelStatus::Closed;
  channel_.ends.provider->ring();
}

ReplyRecord* ChannelClient::nextReply() {
  rt::SpscRing& replies = channel_.replies;
  const auto copy = [&info = channel_.info](std::byte* to, const std::byte* from,
                                            std::size_t size) {
    copyForeign(info, to, from, size);
  };
  for (;;) {
    std::byte* const memory = const_cast<std::byte*>(replies.front(copy));
    if (memory == nullptr || !channel_.foreign) return reinterpret_cast<ReplyRecord*>(memory);
    if (replies.frontSize() >= sizeof(ReplyRecord)) return makePossible(memory);
    replies.pop();
  }
}

// The peer controls this memory: clear `shared` so that we never release a pointer that it chose,
// and clamp the stamp to now().
ReplyRecord* ChannelClient::makePossible(std::byte* memory) {
  memory[offsetof(ReplyRecord, shared)] = std::byte{0};
  auto* const reply = reinterpret_cast<ReplyRecord*>(memory);
  reply->stamp = std::clamp(reply->stamp, Time{}, now());
  return reply;
}

void ChannelClient::popReply() {
  ReplyRecord* const reply = nextReply();
  if (reply->shared) releaseSharedSlot(reply->result());
  channel_.replies.pop();
}

// Opens the gate before it looks at the provider: a loss that comes behind the look closes the gate
// again, for its client notices it later still, and no loss is admitted that the operator has not
// seen. Until then the status keeps commands back.
ResumeOutcome ChannelClient::resume() {
  ConnectionWatch* const watch = channel_.terms.watch.get();
  if (watch == nullptr || !watch->awaitsOperator.exchange(false)) return ResumeOutcome::NotAwaiting;
  if (errorOf(channel_.status.load()) == Errc{}) return ResumeOutcome::Resumed;
  watch->awaitsOperator = true;
  return ResumeOutcome::ProviderLost;
}

}  // namespace suture
