#include <suture/session/provider/peer_host.h>
#include <suture/session/provider/peer_server.h>

#include <utility>

namespace suture {
namespace {

constexpr std::size_t kMostCallers = 1024;

// A session has one for each lane that needs it, and one for each connection of large values.
constexpr std::size_t kMostSecondSockets = 1024;

// Peers choose the names, so the sums of connections that are over are dropped beyond that many.
constexpr std::size_t kMostAccounts = 1024;

}  // namespace

PeerHost::PeerHost(rpc::ControlThread& control, const Lanes& lanes, const Directory& directory,
                   Network::ServerOf serverOf, Network::TaskOf taskOf, const rpc::Address& address,
                   const Security& security, std::uint64_t incarnation)
    : control_(control),
      lanes_(lanes),
      directory_(directory),
      serverOf_(std::move(serverOf)),
      taskOf_(std::move(taskOf)),
      incarnation_(incarnation),
      policy_(security.policy),
      whenPublished_(nullptr),
      secondSockets_(kMostSecondSockets),
      refusals_(directory.process()),
      server_(
          std::in_place, control.port(), address,
          [this](std::shared_ptr<rpc::Caller> caller) { return offerTo(std::move(caller)); },
          refusals_, rpc::StreamLimits{}, kMostCallers, security.trust(),
          [this](const rpc::Token& token, rpc::ByteStream bytes) {
            sockets_.arrived(token, kj::mv(bytes));
          }) {
  auto pair = kj::newPromiseAndFulfiller<void>();
  published_ = kj::mv(pair.fulfiller);
  whenPublished_ = pair.promise.fork();
}

capnp::Capability::Client PeerHost::offerTo(std::shared_ptr<rpc::Caller> caller) {
  if (policy_.admits(caller->identity)) {
    return wire::Peer::Client(kj::heap<PeerServer>(*this, std::move(caller)));
  }
  const rpc::PeerIdentity who = caller->identity;
  return rpc::turnAway(refusals_, who,
                       "talk to process '" + directory_.process() +
                           "': its policy has no rule for " + who.text() +
                           ". Add one, or use another process.");
}

std::vector<std::shared_ptr<Channel>> PeerHost::served() const {
  const std::lock_guard lock(mutex_);
  return served_;
}

// A process that stood still may have lost its name to another meanwhile: it goes on with its
// session, asks last, and must not take the connection back from the one that has the name.
std::string PeerHost::whySuperseded(const std::string& client, const std::string& name,
                                    const Latest& asked) const {
  const auto held = latest_.find(client);
  if (held == latest_.end()) return "";
  const Latest& latest = held->second;
  if (latest.bootId == asked.bootId && asked.epoch < latest.epoch) {
    return "connecting " + name +
           ": a later attempt of the same interface has come first. Nothing has to be done.";
  }
  if (latest.incarnation != asked.incarnation && asked.greeting < latest.greeting) {
    return "connecting " + name +
           ": another process of the same name came later and has this connection. End one of the "
           "two.";
  }
  return "";
}

void PeerHost::endLatest(const std::string& client) {
  if (const auto held = latest_.find(client); held != latest_.end()) held->second.end->end();
}

void PeerHost::forget(const rpc::ProviderEnd& end) {
  std::erase_if(latest_, [&](const auto& one) { return one.second.end == &end; });
}

void PeerHost::forgetClosed() {
  const std::lock_guard lock(mutex_);
  std::erase_if(served_, [](const auto& one) { return one->status == ChannelStatus::Closed; });
}

// Attempts that are under way at the same time share one ledger.
std::shared_ptr<Ledger> PeerHost::ledgerOf(const std::string& name, std::uint64_t client) {
  const bool named = client != 0;  // else the process is too old to tell an incarnation
  const auto account = accounts_.find(name);
  if (named && account != accounts_.end() && account->second.client == client) {
    return account->second.ledger;
  }
  std::erase_if(attempted_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<Ledger>& attempted = attempted_[{name, client}];
  std::shared_ptr<Ledger> ledger = named ? attempted.lock() : nullptr;
  if (ledger == nullptr) ledger = std::make_shared<Ledger>(ConnectionEnd::Provider, history_);
  attempted = ledger;
  return ledger;
}

void PeerHost::keepLedger(const std::string& name, std::uint64_t client,
                          std::shared_ptr<Ledger> ledger) {
  if (accounts_.size() >= kMostAccounts && !accounts_.contains(name)) {
    history_ = Ledger::History::Forgotten;
    std::erase_if(accounts_, [](const auto& one) { return one.second.ledger.use_count() == 1; });
  }
  attempted_.erase({name, client});
  accounts_[name] = {client, std::move(ledger)};
}

void PeerHost::remember(std::shared_ptr<Channel> channel) {
  forgetClosed();
  const std::lock_guard lock(mutex_);
  served_.push_back(std::move(channel));
}

}  // namespace suture
