#include <suture/base/field_path.h>
#include <suture/base/words.h>
#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/provided/event_emission.h>
#include <suture/component/provided/latched.h>

#include <algorithm>
#include <memory>

namespace suture {
namespace {

std::size_t payloadWords(const InterfaceInfo& info) {
  std::size_t size = 0;
  for (const EventInfo& event : info.events) size = std::max<std::size_t>(size, event.payloadSize);
  return wordsFor(size);
}

}  // namespace

EventEmission::EventEmission(InterfaceClients& clients)
    : clients_(clients), replayed_(payloadWords(clients.info())) {
  for (const EventInfo& event : clients.info().events) {
    latched_.push_back(event.latched ? std::make_unique<Latched>(event) : nullptr);
  }
}

EventEmission::~EventEmission() = default;

// Only the task's own thread may, but any thread of a device.
bool EventEmission::inWrongThread() const {
  const Component& owner = clients_.owner();
  return owner.ownsThread() && owner.ownedByAnotherThread();
}

Errc EventEmission::judge(std::uint16_t event, const std::byte* slot, bool fits) {
  if (!fits) return Errc::TooLarge;
  FieldPath path;
  if (clients_.info().events[event].admits(slot, &path)) return Errc{};
  clients_.noteInvalid(path, nullptr);
  return Errc::Invalid;
}

// A task's new subscribers join at its next cycle, together with the latched values.
template <class Visit>
void EventEmission::forEachSubscriber(std::uint16_t event, const Visit& visit) const {
  const bool ownThread = clients_.owner().ownsThread();
  clients_.channels().forEach([&](ChannelList::Node& node) {
    const Channel& channel = *node.channel;
    const EventSet wanted = ownThread ? node.served : channel.subscribed();
    if ((wanted >> event & 1) == 0) return;
    const EventSet direct = ownThread ? node.direct : channel.direct.events();
    visit(node.channel, (direct >> event & 1) != 0);
  });
}

Errc EventEmission::emit(std::uint16_t event, const std::byte* slot, bool fits) {
  if (inWrongThread()) return Errc::WrongThread;
  if (const Errc error = judge(event, slot, fits); error != Errc{}) return error;
  const EventInfo& info = clients_.info().events[event];
  const Time stamp = now();
  const std::span payload(slot, info.payloadSize);
  if (info.latched) keepLatched(event, stamp, payload);
  forEachSubscriber(event, [&](const std::shared_ptr<Channel>& channel, bool direct) {
    deliver(*channel, event, stamp, payload, direct);
  });
  return Errc{};
}

std::shared_ptr<Channel> EventEmission::onlySubscriber(std::uint16_t event) const {
  std::shared_ptr<Channel> only;
  bool lends = true;
  forEachSubscriber(event, [&](const std::shared_ptr<Channel>& channel, bool direct) {
    lends = lends && only == nullptr && !direct;
    only = channel;
  });
  return lends ? only : nullptr;
}

void EventEmission::deliverLent(Channel& channel, std::uint16_t event, std::byte* payload) {
  if (channel.events.pushLent(event, now(), payload)) {
    channel.countSent(sizeof(rt::EventRecord) + clients_.info().events[event].payloadSize);
  }
  clients_.owner().ringForArrival(channel);
}

void EventEmission::deliver(Channel& channel, std::uint16_t event, Time stamp,
                            std::span<const std::byte> payload, bool direct) {
  if (direct && channel.direct.call(event, payload.data())) {
    channel.counts->eventsHeardHere.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  if (channel.events.push(event, stamp, payload)) {
    channel.countSent(sizeof(rt::EventRecord) + payload.size());
  }
  clients_.owner().ringForArrival(channel);
}

void EventEmission::keepLatched(std::uint16_t event, Time stamp,
                                std::span<const std::byte> payload) {
  Latched& latched = *latched_[event];
  // A device may emit it in two threads at once. These have no order, so either value may stay.
  if (latched.keeping.test_and_set(std::memory_order_acquire)) return;
  std::copy(payload.begin(), payload.end(), latched.values.draft(0));
  if (clients_.info().events[event].sharedPayload) sharedSlotIn(payload.data())->retain();
  latched.values.publish(stamp, {.valid = 1});
  latched.keeping.clear(std::memory_order_release);
}

void EventEmission::replay(Channel& channel, EventSet events, std::span<std::uint64_t> memory) {
  for (std::uint16_t i = 0; i < clients_.info().events.size(); ++i) {
    if (clients_.info().events[i].latched && (events >> i & 1) != 0) replay(channel, i, memory);
  }
}

void EventEmission::replay(Channel& channel, std::uint16_t event, std::span<std::uint64_t> memory) {
  const EventInfo& info = clients_.info().events[event];
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

// Skips local clients of a device, which greet themselves because it has no cycle.
void EventEmission::greet(ChannelList::Node& node) {
  Channel& channel = *node.channel;
  if (channel.ends.device != nullptr) return;
  const EventSet joining = channel.provider.takeJoining();
  node.served = channel.subscribed();
  node.direct = channel.direct.events();
  if (joining != 0) replay(channel, joining & node.served, replayed_);
}

void EventEmission::greetLocal(Channel& channel) {
  if (channel.ends.device == nullptr) return;
  const EventSet joining = channel.provider.takeJoining() & channel.subscribed();
  if (joining == 0) return;
  std::vector<std::uint64_t> memory(replayed_.size());
  replay(channel, joining, memory);
}

}  // namespace suture
