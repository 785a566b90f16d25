#include <suture/session/provider/peer_host.h>
#include <suture/session/provider/peer_server.h>

#include <utility>

namespace suture {
namespace {

constexpr std::size_t kMostCallers = 1024;

}  // namespace

PeerHost::PeerHost(ServingProcess process, const net::Address& address, net::Trust trust)
    : shared_(std::move(process)),
      server_(
          std::in_place, shared_.control.port(), address,
          [this](std::shared_ptr<framing::Caller> caller) { return offerTo(std::move(caller)); },
          shared_.refusals, framing::StreamLimits{}, framing::LinkLimits{.all = kMostCallers},
          std::move(trust),
          [this](const framing::Token& token, net::ByteStream bytes) {
            arrived(token, kj::mv(bytes));
          }) {}

capnp::Capability::Client PeerHost::offerTo(std::shared_ptr<framing::Caller> caller) {
  if (shared_.policy.admits(caller->identity)) {
    return wire::Peer::Client(kj::heap<PeerServer>(shared_, std::move(caller)));
  }
  const net::PeerIdentity who = caller->identity;
  return framing::turnAway(shared_.refusals, who,
                           "talk to process '" + shared_.directory.process() +
                               "': its policy has no rule for " + who.text() +
                               ". Add one, or use another process.");
}

void PeerHost::arrived(const framing::Token& token, net::ByteStream bytes) {
  const std::string who = bytes.peer().text();
  if (shared_.sockets.arrived(token, kj::mv(bytes))) return;
  shared_.refusals.add(who, "open a second connection to process '" + shared_.directory.process() +
                                "': it awaits none that shows this token. Connect anew.");
}

}  // namespace suture
