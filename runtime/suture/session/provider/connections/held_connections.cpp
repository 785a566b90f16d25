#include <suture/session/provider/connections/held_connections.h>

#include <utility>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

}  // namespace

HeldConnections::HeldConnections(SharedBySessions& shared, std::string peer,
                                 std::shared_ptr<PeerState> state)
    : shared_(shared),
      peer_(std::move(peer)),
      leases_(shared.control, std::move(state)),
      places_(kMost) {}

std::optional<Refusal> HeldConnections::whyNoPlace(const Endpoint& endpoint, Room& room) {
  if (forgetEnded()) shared_.channels.forgetClosed();
  if (places_.anyFree()) {
    room = {.place = places_.take(), .memory = shared_.memory.share(peer_)};
    return std::nullopt;
  }
  return Refusal{Kind::LIMIT_REACHED, "use '" + endpoint.toString() +
                                          "': this process has been given " +
                                          std::to_string(kMost) +
                                          " interfaces, and none is given more. Let go of some."};
}

std::optional<Refusal> HeldConnections::whyNoMemory(const Endpoint& endpoint, const Room& room,
                                                    std::size_t bytes) {
  auto beyond = shared_.memory.hold(room.memory, bytes);
  if (beyond) {
    shared_.channels.forgetClosed();  // they are kept for reports only
    shared_.channels.sweep();
    beyond = shared_.memory.hold(room.memory, bytes);
  }
  if (!beyond) return std::nullopt;
  return Refusal{Kind::LIMIT_REACHED,
                 "use '" + endpoint.toString() + "': the connection would take " +
                     std::to_string(bytes) + " bytes, and of the " + std::to_string(beyond->limit) +
                     " for the connections of " + beyond->whose + " " +
                     std::to_string(beyond->left) +
                     " are left. Let go of some, or give its commands and events shorter queues."};
}

void HeldConnections::keep(kj::Own<ProviderEnd> end, const std::shared_ptr<Channel>& channel,
                           Room room) {
  shared_.memory.keep(channel, std::move(room.memory));
  leases_.watch(*end);
  held_.push_back({kj::mv(end), channel, std::move(room.place)});
}

// A client that leaves may have sent a heartbeat before its connections ended, which travel on
// sockets of their own; it stays if it says more after that.
void HeldConnections::look() {
  if (std::exchange(anyEnded_, forgetEnded())) shared_.channels.forgetClosed();
  for (Held& held : held_) held.end->tellEarlier();
}

void HeldConnections::end() {
  for (Held& held : held_) {
    shared_.latest.forget(*held.end);
    held.end->close();
  }
}

bool HeldConnections::forgetEnded() {
  return std::erase_if(held_, [this](const Held& held) {
           const bool over = held.channel->status == ChannelStatus::Closed;
           if (over) shared_.latest.forget(*held.end);
           return over;
         }) > 0;
}

}  // namespace suture
