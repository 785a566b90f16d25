#include <suture/base/field_path.h>
#include <suture/component/channel/channel.h>
#include <suture/component/latched.h>
#include <suture/component/provided.h>

#include <algorithm>
#include <memory>

namespace suture {

// Only the task's own thread may, but any thread of a device.
bool ProvidedBase::emitsInWrongThread() const {
  return owner_.ownsThread() && owner_.ownedByAnotherThread();
}

Errc ProvidedBase::judge(std::uint16_t event, const std::byte* slot, bool fits) {
  if (!fits) return Errc::TooLarge;
  FieldPath path;
  if (info_.events[event].admits(slot, &path)) return Errc{};
  noteInvalid(path, nullptr);
  return Errc::Invalid;
}

// A task's new subscribers join at its next cycle, together with the latched values.
template <class Visit>
void ProvidedBase::forEachSubscriber(std::uint16_t event, const Visit& visit) const {
  const bool ownThread = owner_.ownsThread();
  channels_.forEach([&](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    const EventSet wanted = ownThread ? node.served : channel.subscribed();
    if ((wanted >> event & 1) == 0) return;
    const EventSet direct = ownThread ? node.direct : channel.direct.events();
    visit(node.channel, (direct >> event & 1) != 0);
  });
}

Errc ProvidedBase::emit(std::uint16_t event, const std::byte* slot, bool fits) {
  if (emitsInWrongThread()) return Errc::WrongThread;
  if (const Errc error = judge(event, slot, fits); error != Errc{}) return error;
  const EventInfo& info = info_.events[event];
  const Time stamp = now();
  const std::span payload(slot, info.payloadSize);
  if (info.latched) keepLatched(event, stamp, payload);
  forEachSubscriber(event, [&](const std::shared_ptr<Channel>& channel, bool direct) {
    deliver(*channel, event, stamp, payload, direct);
  });
  return Errc{};
}

std::shared_ptr<Channel> ProvidedBase::onlySubscriber(std::uint16_t event) const {
  std::shared_ptr<Channel> only;
  bool lends = true;
  forEachSubscriber(event, [&](const std::shared_ptr<Channel>& channel, bool direct) {
    lends = lends && only == nullptr && !direct;
    only = channel;
  });
  return lends ? only : nullptr;
}

void ProvidedBase::deliverLent(Channel& channel, std::uint16_t event, std::byte* payload) {
  if (channel.events.pushLent(event, now(), payload)) {
    channel.countSent(sizeof(rt::EventRecord) + info_.events[event].payloadSize);
  }
  owner_.ringForArrival(channel);
}

void ProvidedBase::deliver(Channel& channel, std::uint16_t event, Time stamp,
                           std::span<const std::byte> payload, bool direct) {
  if (direct && channel.direct.call(event, payload.data())) {
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
  const auto isDirect = [&] { return (channel.direct.events() >> event & 1) != 0; };
  // A device may emit meanwhile: go on until the newest value has been delivered last.
  for (Time replayed{};;) {
    const Result<Time> emitted = latched_[event]->values.read(0, payload.data());
    if (!emitted) return;
    const bool news = *emitted != replayed;
    if (news) deliver(channel, event, *emitted, payload, isDirect());
    if (info.sharedPayload) releaseSharedSlot(payload.data());
    if (!news) return;
    replayed = *emitted;
  }
}

}  // namespace suture
