#include <suture/loop/deadline.h>
#include <suture/loop/failure.h>
#include <suture/names/manager_session.h>

#include <algorithm>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

constexpr Duration kLongestWait = std::chrono::minutes(1);

/// Knows who asks at a link, reports what that peer is refused, and counts what the registry holds
/// for it.
struct Asker {
  net::PeerIdentity identity;
  net::Refusals& refusals;
  std::shared_ptr<Holding> holding;

  void refuse(const Refusal& refusal, wire::Refusal::Builder out) const {
    refusals.add(identity.text(), refusal.text);
    toWire(refusal, out);
  }
};

/// Holds a name for as long as its client holds it, and says that the client lives.
class LeaseServer final : public wire::Lease::Server {
 public:
  LeaseServer(kj::Own<NameService> names, Asker asker, std::string name, std::uint64_t generation)
      : names_(kj::mv(names)),
        asker_(std::move(asker)),
        name_(std::move(name)),
        generation_(generation) {}
  ~LeaseServer() noexcept(false) { names_->registry().remove(name_, generation_); }

 protected:
  kj::Promise<void> update(UpdateContext context) override {
    const auto updated = names_->registry().update(name_, generation_,
                                                   fromWire(context.getParams().getComponents()));
    if (updated) return kj::READY_NOW;
    asker_.refusals.add(asker_.identity.text(), updated.error().text);
    return loop::failure(kj::Exception::Type::FAILED, updated.error().text);
  }

  kj::Promise<void> renew(RenewContext context) override {
    Registry& registry = names_->registry();
    const bool wasKnown = registry.find(name_) != nullptr;
    const bool held = registry.renew(name_, generation_);
    context.getResults().setHeld(held);
    if (held && !wasKnown) names_->announce(name_);
    return kj::READY_NOW;
  }

 private:
  kj::Own<NameService> names_;
  const Asker asker_;
  const std::string name_;
  const std::uint64_t generation_;
};

class SessionServer final : public wire::Session::Server {
 public:
  SessionServer(kj::Own<NameService> names, Asker asker)
      : names_(kj::mv(names)), asker_(std::move(asker)) {}

 protected:
  kj::Promise<void> register_(RegisterContext context) override {
    ProcessRecord process = fromWire(context.getParams().getProcess());
    const std::string name = process.name;
    auto results = context.getResults();
    if (!asker_.identity.mayBe(name)) {
      asker_.refuse({Kind::NOT_PERMITTED,
                     "register process '" + name + "': the caller has the certificate of " +
                         asker_.identity.text() + ". Give it its own name or its own keys."},
                    results.initRefused());
      return kj::READY_NOW;
    }
    const auto generation = names_->registry().add(std::move(process), asker_.holding);
    if (!generation) {
      asker_.refuse(generation.error(), results.initRefused());
      return kj::READY_NOW;
    }
    results.setGeneration(*generation);
    results.setLease(kj::heap<LeaseServer>(kj::addRef(*names_), asker_, name, *generation));
    names_->announce(name);
    return kj::READY_NOW;
  }

  kj::Promise<void> resolve(ResolveContext context) override {
    const std::string name = codec::stringOf(context.getParams().getProcess());
    const std::uint32_t wait = context.getParams().getWaitMilliseconds();
    if (const auto refusal = Registry::whyTooLong(name)) {
      asker_.refuse(*refusal, context.getResults().initRefused());
      return kj::READY_NOW;
    }
    context.releaseParams();  // many calls may wait, and a message may be large
    const bool waits = wait != 0 && names_->registry().find(name) == nullptr;
    const std::string full = waits ? names_->whyNoRoom(asker_.holding) : "";
    if (!full.empty()) {
      asker_.refuse({Kind::LIMIT_REACHED, "find process '" + name + "': " + full +
                                              ". It is not there now; ask again later."},
                    context.getResults().initRefused());
      return kj::READY_NOW;
    }
    context.allowCancellation();
    return names_->whenKnown(name, wait, asker_.holding)
        .then([this, context, name, wait]() mutable {
          auto results = context.getResults();
          if (const ProcessRecord* process = names_->registry().find(name)) {
            toWire(*process, results.initFound());
          } else {
            toWire(names_->registry().unknown(name, wait), results.initRefused());
          }
        });
  }

  kj::Promise<void> list(ListContext context) override {
    const Registry::Page page =
        names_->registry().list(codec::stringOf(context.getParams().getAfter()));
    auto results = context.getResults();
    results.setMore(page.more);
    const auto count = static_cast<unsigned>(page.processes.size());
    auto processes = results.initProcesses(count);
    for (unsigned i = 0; i < count; ++i) toWire(page.processes[i], processes[i]);
    return kj::READY_NOW;
  }

 private:
  kj::Own<NameService> names_;
  const Asker asker_;
};

class GlobalManagerServer final : public wire::GlobalManager::Server {
 public:
  GlobalManagerServer(kj::Own<NameService> names, net::Refusals& refusals,
                      std::shared_ptr<framing::Caller> caller)
      : names_(kj::mv(names)),
        caller_(std::move(caller)),
        asker_{.identity = caller_->identity,
               .refusals = refusals,
               .holding = names_->holdingOf(caller_->identity)} {}

 protected:
  kj::Promise<void> hello(HelloContext context) override {
    const std::uint16_t theirs = context.getParams().getVersion();
    const std::uint16_t ours = wire::PROTOCOL_VERSION;
    if (theirs == ours) {
      caller_->known = true;
      context.getResults().setSession(kj::heap<SessionServer>(kj::addRef(*names_), asker_));
    } else {
      asker_.refuse({Kind::VERSION_MISMATCH, "talk to the global manager: it speaks version " +
                                                 std::to_string(ours) + " of the protocol and '" +
                                                 codec::stringOf(context.getParams().getProgram()) +
                                                 "' speaks version " + std::to_string(theirs) +
                                                 ". Build both from the same release."},
                    context.getResults().initRefused());
    }
    return kj::READY_NOW;
  }

 private:
  kj::Own<NameService> names_;
  const std::shared_ptr<framing::Caller> caller_;
  const Asker asker_;  // shared by all sessions on the link, and so is what it may hold
};

}  // namespace

kj::Promise<void> NameService::age() {
  return timer_.afterDelay(wire::RENEWAL_MILLISECONDS * kj::MILLISECONDS).then([this] {
    registry_.age();
    return age();
  });
}

void NameService::announce(const std::string& name) {
  for (Waiting& one : waiting_) {
    if (one.name == name) one.arrived->fulfill();
  }
  forgetAnswered();
}

// Drops those that have been answered, whose time is up, or that are gone.
void NameService::forgetAnswered() {
  kj::Vector<Waiting> others;
  for (Waiting& one : waiting_) {
    if (one.arrived->isWaiting()) others.add(kj::mv(one));
  }
  waiting_ = kj::mv(others);
}

std::shared_ptr<Holding> NameService::holdingOf(const net::PeerIdentity& peer) {
  auto link = std::make_shared<Holding>();
  if (peer.proof == net::PeerIdentity::Proof::None) return link;
  std::erase_if(peers_, [](const auto& known) { return known.second.expired(); });
  std::weak_ptr<Holding>& known = peers_[peer.text()];
  link->peer = known.lock();
  if (link->peer == nullptr) known = link->peer = std::make_shared<Holding>();
  return link;
}

template <class Counts>
std::size_t NameService::waitingOf(const Counts& counts) const {
  return static_cast<std::size_t>(std::count_if(
      waiting_.begin(), waiting_.end(), [&](const Waiting& one) { return counts(*one.link); }));
}

// One process that asks again and again must leave room to those that start, and one user to
// others.
std::string NameService::whyNoRoom(const std::shared_ptr<Holding>& link) {
  const auto why = [&]() -> std::string {
    if (waitingOf([&](const Holding& one) { return &one == link.get(); }) >= kMostWaitingOfALink) {
      return std::to_string(kMostWaitingOfALink) +
             " of this link wait for names, and no more of one link may";
    }
    const auto isOfPeer = [&](const Holding& one) { return one.peer == link->peer; };
    if (link->peer != nullptr && waitingOf(isOfPeer) >= kMostWaitingOfAPeer) {
      return std::to_string(kMostWaitingOfAPeer) +
             " of this user, or with this certificate, wait for names, and no more of one may";
    }
    if (waiting_.size() < kMostWaiting) return "";
    return std::to_string(kMostWaiting) + " wait for names here, and no more may";
  };
  if (!why().empty()) forgetAnswered();
  return why();
}

kj::Promise<void> NameService::whenKnown(const std::string& name, std::uint32_t waitMilliseconds,
                                         const std::shared_ptr<Holding>& link) {
  if (waitMilliseconds == 0 || registry_.find(name) != nullptr) return kj::READY_NOW;
  auto pair = kj::newPromiseAndFulfiller<void>();
  waiting_.add(Waiting{name, link, kj::mv(pair.fulfiller)});
  const Duration wait =
      std::min<Duration>(std::chrono::milliseconds(waitMilliseconds), kLongestWait);
  return loop::unlessLate(timer_, wait, kj::mv(pair.promise), [] {});
}

wire::GlobalManager::Client makeGlobalManager(kj::Own<NameService> names, net::Refusals& refusals,
                                              std::shared_ptr<framing::Caller> caller) {
  return kj::heap<GlobalManagerServer>(kj::mv(names), refusals, std::move(caller));
}

}  // namespace suture
