#include <suture/base/field_path.h>
#include <suture/component/channel/channel.h>
#include <suture/component/latched.h>
#include <suture/component/provided.h>

#include <algorithm>

namespace suture {

Errc ProvidedBase::emit(std::uint16_t event, const std::byte* slot, bool fits) {
  const bool ownThread = owner_.ownsThread();
  // Only the task's own thread may walk its channels and fill its subscribers' queues.
  if (ownThread && owner_.ownedByAnotherThread()) return Errc::WrongThread;
  if (!fits) return Errc::TooLarge;
  const EventInfo& info = info_.events[event];
  if (FieldPath path; !info.admits(slot, &path)) {
    noteInvalid(path, nullptr);
    return Errc::Invalid;
  }
  const Time stamp = now();
  const std::span payload(slot, info.payloadSize);
  if (info.latched) keepLatched(event, stamp, payload);
  channels_.forEach([&](ChannelList::Node& node) {
    Channel& channel = *node.channel;
    // A task's new subscribers join at its next cycle, together with the latched values.
    const EventSet wanted = ownThread ? node.served : channel.subscribed();
    if ((wanted >> event & 1) == 0) return;
    deliver(channel, event, stamp, payload, ownThread ? node.direct : channel.direct.events());
  });
  return Errc{};
}

void ProvidedBase::deliver(Channel& channel, std::uint16_t event, Time stamp,
                           std::span<const std::byte> payload, EventSet direct) {
  if ((direct >> event & 1) != 0 && channel.direct.call(event, payload.data())) {
    channel.counts->eventsHeardHere.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  if (channel.events.push(event, stamp, payload)) {
    channel.countSent(sizeof(rt::EventRecord) + payload.size());
  }
  owner_.ringForArrival(channel);
}

void ProvidedBase::keepLatched(std::uint16_t event, Time stamp,
                               std::span<const std::byte> payload) {
  Latched& latched = *latched_[event];
  // A device may emit it in two threads at once. These have no order, so either value may stay.
  if (latched.keeping.test_and_set(std::memory_order_acquire)) return;
  std::copy(payload.begin(), payload.end(), latched.values.draft(0));
  if (info_.events[event].sharedPayload) sharedSlotIn(payload.data())->retain();
  latched.values.publish(stamp, {.valid = 1});
  latched.keeping.clear(std::memory_order_release);
}

void ProvidedBase::replay(Channel& channel, EventSet events, std::span<std::uint64_t> memory) {
  for (std::uint16_t i = 0; i < info_.events.size(); ++i) {
    if (info_.events[i].latched && (events >> i & 1) != 0) replay(channel, i, memory);
  }
}

void ProvidedBase::replay(Channel& channel, std::uint16_t event, std::span<std::uint64_t> memory) {
  const EventInfo& info = info_.events[event];
  const auto payload = std::as_writable_bytes(memory).first(info.payloadSize);
  // A device may emit meanwhile: go on until the newest value has been delivered last.
  for (Time replayed{};;) {
    const Result<Time> emitted = latched_[event]->values.read(0, payload.data());
    if (!emitted) return;
    const bool news = *emitted != replayed;
    if (news) deliver(channel, event, *emitted, payload, channel.direct.events());
    if (info.sharedPayload) releaseSharedSlot(payload.data());
    if (!news) return;
    replayed = *emitted;
  }
}

}  // namespace suture
