#include <suture/session/provider/peer_host.h>
#include <suture/session/provider/peer_server.h>

#include <utility>

namespace suture {
namespace {

constexpr std::size_t kMostCallers = 1024;

// A session has one for each lane that needs it, and one for each connection of large values.
constexpr std::size_t kMostSecondSockets = 1024;

}  // namespace

PeerHost::PeerHost(loop::ControlThread& control, const Lanes& lanes, const Directory& directory,
                   ServiceThreads& threads, std::uint64_t incarnation, const net::Address& address,
                   const Security& security)
    : control_(control),
      lanes_(lanes),
      directory_(directory),
      threads_(threads),
      incarnation_(incarnation),
      policy_(security.policy),
      whenPublished_(nullptr),
      secondSockets_(kMostSecondSockets),
      refusals_(directory.process()),
      server_(
          std::in_place, control.port(), address,
          [this](std::shared_ptr<framing::Caller> caller) { return offerTo(std::move(caller)); },
          refusals_, framing::StreamLimits{}, framing::LinkLimits{.all = kMostCallers},
          security.trust(),
          [this](const framing::Token& token, net::ByteStream bytes) {
            arrived(token, kj::mv(bytes));
          }) {
  auto pair = kj::newPromiseAndFulfiller<void>();
  published_ = kj::mv(pair.fulfiller);
  whenPublished_ = pair.promise.fork();
}

capnp::Capability::Client PeerHost::offerTo(std::shared_ptr<framing::Caller> caller) {
  if (policy_.admits(caller->identity)) {
    return wire::Peer::Client(kj::heap<PeerServer>(*this, std::move(caller)));
  }
  const net::PeerIdentity who = caller->identity;
  return framing::turnAway(refusals_, who,
                           "talk to process '" + directory_.process() +
                               "': its policy has no rule for " + who.text() +
                               ". Add one, or use another process.");
}

void PeerHost::arrived(const framing::Token& token, net::ByteStream bytes) {
  const std::string who = bytes.peer().text();
  if (sockets_.arrived(token, kj::mv(bytes))) return;
  refusals_.add(who, "open a second connection to process '" + directory_.process() +
                         "': it awaits none that shows this token. Connect anew.");
}

std::vector<std::shared_ptr<Channel>> PeerHost::served() const {
  const std::lock_guard lock(mutex_);
  return served_;
}

void PeerHost::forgetClosed() {
  ledgers_.letGo();
  const std::lock_guard lock(mutex_);
  std::erase_if(served_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
}

void PeerHost::sweep() {
  for (const Component* const component : directory_.components()) {
    for (ProvidedBase* const provided : component->provided()) provided->sweep();
  }
}

void PeerHost::remember(std::shared_ptr<Channel> channel) {
  forgetClosed();
  const std::lock_guard lock(mutex_);
  served_.push_back(std::move(channel));
}

}  // namespace suture
