#include <suture/component/task/task.h>
#include <suture/lane/shm/shared_memory.h>
#include <suture/lane/status_port.h>
#include <suture/loop/failure.h>
#include <suture/names/describe.h>
#include <suture/rt/state/state_table.h>
#include <suture/session/explain.h>
#include <suture/session/heartbeat.h>
#include <suture/session/notices_sender.h>
#include <suture/session/peer_server.h>
#include <suture/session/tallies.h>
#include <suture/wire/stamps.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/frames.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

// There is a bound, since each has a mailbox of its own for as long as the link stands.
constexpr std::size_t kMostPorts = 256;

/// Sets the clock of either end's channel. `offset`: how far the caller's is ahead of ours, ns.
template <class End>
void setClock(End& end, std::int64_t offset, std::int64_t error) {
  const std::int64_t known = std::max<std::int64_t>(rpc::bounded(error), 0);
  end.setClock(Duration(-rpc::bounded(offset)), Duration(known));
}

/// Ends the connection when the client lets go of it.
class ConnectionServer final : public wire::Connection::Server {
 public:
  explicit ConnectionServer(kj::Own<rpc::ProviderEnd> end) : end_(kj::mv(end)) {}
  ~ConnectionServer() noexcept(false) { end_->close(); }

 protected:
  kj::Promise<void> compared(ComparedContext context) override {
    const auto in = context.getParams();
    setClock(*end_, in.getClockOffset(), in.getClockError());
    return kj::READY_NOW;
  }

 private:
  kj::Own<rpc::ProviderEnd> end_;
};

/// The name of a client whose connections share a link; "" if it is longer than names get.
std::string nameOf(capnp::Data::Reader client) {
  constexpr std::size_t kMost = 64;
  const auto text = client.asChars();
  return text.size() > kMost ? "" : std::string(text.begin(), text.end());
}

}  // namespace

PeerServer::PeerServer(PeerHost& host, std::shared_ptr<rpc::Caller> caller)
    : host_(host), caller_(std::move(caller)), leases_(host.control_) {}

PeerServer::~PeerServer() noexcept(false) {
  for (auto& end : ends_) {
    host_.forget(*end);
    end->close();
  }
}

kj::Promise<void> PeerServer::hello(HelloContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  results.setProcess(textOf(host_.directory_.process()));
  results.setBootId(textOf(bootId()));
  results.setIncarnation(host_.incarnation_);
  bootId_ = stringOf(context.getParams().getBootId());
  incarnation_ = context.getParams().getIncarnation();
  const std::uint16_t theirs = context.getParams().getVersion();
  if (const auto refusal = whyNotProcess(stringOf(context.getParams().getProcess()))) {
    refuse(*refusal, results.initRefused());
  } else if (theirs == wire::PROTOCOL_VERSION) {
    caller_->known = true;
    results.setAccepted();
  } else {
    refuse({Kind::VERSION_MISMATCH,
            "talk to process '" + host_.directory_.process() + "': it speaks version " +
                std::to_string(wire::PROTOCOL_VERSION) + " of the protocol, the caller version " +
                std::to_string(theirs) + ". Build both from the same release."},
           results.initRefused());
  }
  results.setSent(toNanoseconds(now()));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::ping(PingContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  leases_.hear(context.getParams().getHeard());
  for (auto& end : ends_) end->tellEarlier();
  putTasks(results);
  results.setSent(leases_.answer());
  return kj::READY_NOW;
}

void PeerServer::putTasks(wire::Peer::PingResults::Builder results) const {
  const std::vector<Component*> components = host_.directory_.components();
  auto tasks = results.initTasks(static_cast<unsigned>(components.size()));
  for (unsigned i = 0; i < tasks.size(); ++i) {
    const Task* const task = host_.taskOf_(*components[i]);
    tasks[i].setComponent(textOf(components[i]->name()));
    toWire(task == nullptr ? Pulse::Reading{} : task->pulse().read(), tasks[i]);
    if (task != nullptr) tasks[i].setCycles(task->statistics().cycles);
  }
}

kj::Promise<void> PeerServer::describe(DescribeContext context) {
  return host_.whenPublished_.addBranch().then([this, context]() mutable {
    const auto components = describeComponents(host_.directory_);
    toWire(components,
           context.getResults().initComponents(static_cast<unsigned>(components.size())));
  });
}

void PeerServer::refuse(const Refusal& refusal, wire::Refusal::Builder out) {
  host_.refusals_.add(caller_->identity.text(), refusal.text);
  toWire(refusal, out);
}

template <class Attempt, class Refuse>
kj::Promise<void> PeerServer::whenThere(Attempt attempt, Refuse refuse) {
  try {
    return attempt();
  } catch (const SetupError&) {
    // The interface may still come, since the process is perhaps still adding components.
  }
  return host_.whenPublished_.addBranch().then([attempt, refuse]() mutable -> kj::Promise<void> {
    try {
      return attempt();
    } catch (const SetupError& error) {
      refuse(Refusal{Kind::NO_SUCH_INTERFACE, error.what()});
      return kj::READY_NOW;
    }
  });
}

std::optional<Refusal> PeerServer::whyNotProcess(const std::string& name) const {
  if (caller_->identity.mayBe(name)) return std::nullopt;
  return Refusal{Kind::NOT_PERMITTED,
                 "talk to process '" + host_.directory_.process() +
                     "': the caller says that it is '" + name + "' and has the certificate of " +
                     caller_->identity.text() + ". Give it its own name or its own keys."};
}

std::optional<Refusal> PeerServer::whyNotGiven(const Endpoint& endpoint) const {
  const rpc::PeerIdentity& who = caller_->identity;
  if (ends_.size() == kMostPorts) {
    return Refusal{Kind::LIMIT_REACHED, "use '" + endpoint.toString() +
                                            "': this link has been given " +
                                            std::to_string(kMostPorts) +
                                            " interfaces, and no link is given more. Use another."};
  }
  if (host_.policy_.access(who, endpoint) != Access::None) return std::nullopt;
  return Refusal{Kind::NOT_PERMITTED, "use '" + endpoint.toString() + "': the policy of process '" +
                                          endpoint.process + "' does not give it to " + who.text() +
                                          ". Add it to the role of that rule."};
}

bool PeerServer::mayOnlyRead(const Endpoint& endpoint) const {
  return host_.policy_.access(caller_->identity, endpoint) == Access::Read;
}

kj::Promise<void> PeerServer::connect(ConnectContext context) {
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getToComponent(), in.getProvided());
  auto withheld = whyNotProcess(stringOf(in.getFromProcess()));
  if (!withheld) withheld = whyNotGiven(endpoint);
  if (withheld) {
    refuse(*withheld, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  caller_->known = true;
  return whenThere(
      [this, context, endpoint]() mutable {
        return decide(host_.directory_.provided(endpoint), endpoint, context);
      },
      [this, context](const Refusal& refusal) mutable {
        refuse(refusal, context.getResults().initRefused());
      });
}

/// A request that will be accepted.
struct PeerServer::Asked {
  ProvidedBase& provided;
  std::string client;  // the required interface, with its process
  Endpoint endpoint;
  std::string name;
  Match match;
  EventSet events;  // those that the client wants, by their places here
  ConnectContext context;
};

kj::Promise<void> PeerServer::decide(ProvidedBase& provided, const Endpoint& endpoint,
                                     ConnectContext& context) {
  auto in = context.getParams();
  const Endpoint client{stringOf(in.getFromProcess()), stringOf(in.getFromComponent()),
                        stringOf(in.getRequired())};
  const std::string name = client.toString() + " -> " + endpoint.toString();
  const std::string contract = stringOf(in.getContract()), hash = stringOf(in.getHash()),
                    description = stringOf(in.getDescription());
  try {
    const Match match = requireCompatibleContract(describedInfo(contract, hash, description),
                                                  provided.info(), name);
    requireSameFrames(fromWire(in.getFrames()), provided.frames(), name);
    if (in.getEpoch() == 0 || takesOver(client.toString(), name, context)) {
      return accept({provided, client.toString(), endpoint, name, match,
                     fromWireNumbers(match.contract->wireEvents, in.getEvents()), context});
    }
    return kj::READY_NOW;
  } catch (const SetupError& error) {
    refuse({Kind::CONTRACT_MISMATCH, error.what()}, context.getResults().initRefused());
    return kj::READY_NOW;
  }
}

// One required interface has one connection: the latest.
bool PeerServer::takesOver(const std::string& client, const std::string& name,
                           ConnectContext& context) {
  if (host_.isSuperseded(client, bootId_, context.getParams().getEpoch())) {
    refuse({Kind::ALREADY_CONNECTED,
            "connecting " + name +
                ": a later attempt of the same interface has come first. Nothing has to be done."},
           context.getResults().initRefused());
    return false;
  }
  host_.endLatest(client);
  return true;
}

// Takes the fastest lane that can be had of those asked for.
kj::Promise<void> PeerServer::accept(Asked asked) {
  auto in = asked.context.getParams();
  if (!in.hasMemory()) return acceptSlower(asked, "");
  const InterfaceInfo* const contract = sameContract(asked.provided.info(), stringOf(in.getHash()));
  const std::string reason = mayOnlyRead(asked.endpoint)
                                 ? "the policy gives it for reading only"
                                 : whyOtherSlots(contract, stringOf(in.getMemory().getLayout()));
  if (!reason.empty()) return acceptSlower(asked, reason);
  return receive(in.getMemory().getBell(), sizeof(std::uint64_t), MemoryBlock::Others::Write)
      .then([this, asked, contract](std::shared_ptr<MemoryBlock> bell) mutable {
        shareMemory(asked, *contract, std::move(bell));
      })
      .catch_([this, asked](kj::Exception&& failure) mutable {
        return acceptSlower(asked, rpc::describe(failure));
      });
}

kj::Promise<void> PeerServer::acceptSlower(Asked& asked, const std::string& laneReason) {
  auto in = asked.context.getParams();
  if (!in.hasFrame()) return serveCalls(asked, laneReason);
  const InterfaceInfo* const contract = sameContract(asked.provided.info(), stringOf(in.getHash()));
  const std::string reason = whyOtherSlots(contract, stringOf(in.getFrame().getLayout()));
  if (!reason.empty()) return serveCalls(asked, reason);
  try {
    sendFrames(asked, *contract, laneReason);
    return kj::READY_NOW;
  } catch (const SetupError& error) {
    return serveCalls(asked, error.what());
  }
}

wire::ConnectResults::Accepted::Builder PeerServer::accepted(Asked& asked, rpc::ProviderEnd& end) {
  const auto in = asked.context.getParams();
  // Keep the end before it becomes the latest: what the caller sent may be anything, and throw.
  end.setListener(
      kj::heap<NoticesSender>(host_.control_, in.getNotices(), asked.match.contract->wireEvents));
  ends_.add(kj::addRef(end));
  leases_.grant(end, in.getSilence());
  if (in.getEpoch() != 0) host_.setLatest(asked.client, {bootId_, in.getEpoch(), &end});
  auto out = asked.context.getResults().initAccepted();
  out.setLacking(kj::arrayPtr(asked.match.lacking.data(), asked.match.lacking.size()));
  out.setRows(static_cast<std::uint32_t>(asked.provided.state()->capacity()));
  toWire(end.earlier(), out.initEarlier());
  out.setConnection(kj::heap<ConnectionServer>(kj::addRef(end)));
  return out;
}

kj::Promise<void> PeerServer::serveCalls(Asked& asked, const std::string& laneReason) {
  auto in = asked.context.getParams();
  auto channel = callsChannel(asked.provided, asked.name, asked.events);
  setClock(*channel, in.getClockOffset(), in.getClockError());
  enter(channel);
  auto port = serve(asked.provided, asked.endpoint, std::move(channel));
  auto out = accepted(asked, *port);
  if (!laneReason.empty()) out.setLaneReason(textOf(laneReason));
  out.setContract(asked.provided.info().binding().makeServant(kj::mv(port)));
  return kj::READY_NOW;
}

// Both are on one machine, so they have the same clock.
void PeerServer::shareMemory(Asked& asked, const InterfaceInfo& contract,
                             std::shared_ptr<MemoryBlock> bell) {
  shm::SharedOffer offer =
      shm::offerShared(asked.provided, contract, asked.name, asked.events,
                       host_.serverOf_(asked.provided), std::move(bell), host_.control_.doorbell());
  enter(offer.channel);
  auto out = accepted(asked, *kj::refcounted<StatusPort>(host_.control_, offer.channel));
  toWire(offer.parts, out.initMemory());
  attach(asked.provided, std::move(offer.channel));
}

void PeerServer::sendFrames(Asked& asked, const InterfaceInfo& contract,
                            const std::string& laneReason) {
  auto in = asked.context.getParams();
  const std::shared_ptr<rt::Doorbell> bell = host_.frames_.doorbell();
  const Channel::Ends ends{.client = bell.get(),
                           .provider = &host_.serverOf_(asked.provided),
                           .here = &asked.provided,
                           .watcher = &host_.control_.doorbell()};
  auto channel = std::make_shared<Channel>(contract, asked.name, toString(Lane::Frame), ends,
                                           asked.provided.state(), asked.events);
  channel->clientsBell = bell;
  setClock(*channel, in.getClockOffset(), in.getClockError());
  const auto asks = in.getFrame();
  FrameSockets::Offered offered =
      host_.frames_.offer({.channel = channel, .readOnly = mayOnlyRead(asked.endpoint)},
                          {.name = nameOf(asks.getClient()),
                           .who = caller_->identity,
                           .handsOver = asks.getHandsOver()});
  enter(channel);
  auto out = accepted(asked, *kj::refcounted<StatusPort>(host_.control_, channel));
  if (!laneReason.empty()) out.setLaneReason(textOf(laneReason));
  auto offer = out.initFrame();
  offer.setEpoch(offered.epoch);
  offer.setConnection(offered.connection);
  KJ_IF_MAYBE (socket, offered.socket) offer.setSocket(kj::mv(*socket));
  KJ_IF_MAYBE (token, offered.token) {
    offer.setToken({reinterpret_cast<const kj::byte*>(token->data()), token->size()});
  }
  attach(asked.provided, std::move(channel));
}

kj::Promise<void> PeerServer::open(OpenContext context) {
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getComponent(), in.getInterface());
  if (const auto withheld = whyNotGiven(endpoint)) {
    refuse(*withheld, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  caller_->known = true;
  return whenThere(
      [this, context, endpoint]() mutable -> kj::Promise<void> {
        ProvidedBase& provided = host_.directory_.provided(endpoint);
        const std::string name = "(a plain client) -> " + endpoint.toString();
        auto port = serve(provided, endpoint, callsChannel(provided, name, ~EventSet{0}));
        ends_.add(kj::addRef(*port));
        context.getResults().setContract(provided.info().binding().makeServant(kj::mv(port)));
        return kj::READY_NOW;
      },
      [this, context](const Refusal& refusal) mutable {
        refuse(refusal, context.getResults().initRefused());
      });
}

kj::Promise<void> PeerServer::explain(ExplainContext context) {
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getComponent(), in.getInterface());
  const bool required = in.getSide() == wire::Peer::Side::REQUIRED;
  return whenThere(
      [this, context, endpoint, required]() mutable -> kj::Promise<void> {
        const InterfaceInfo& info = required ? host_.directory_.required(endpoint).info()
                                             : host_.directory_.provided(endpoint).info();
        suture::explain(info, context.getResults().initExplained());
        return kj::READY_NOW;
      },
      [this, context](const Refusal& refusal) mutable {
        refuse(refusal, context.getResults().initRefused());
      });
}

void PeerServer::enter(const std::shared_ptr<Channel>& channel) {
  channel->ledger = host_.ledgerOf(channel->name, incarnation_);
  channel->ledger->begin(channel, incarnation_);
}

Endpoint PeerServer::endpointOf(capnp::Text::Reader component,
                                capnp::Text::Reader interface) const {
  return {host_.directory_.process(), stringOf(component), stringOf(interface)};
}

std::shared_ptr<Channel> PeerServer::callsChannel(ProvidedBase& provided, const std::string& name,
                                                  EventSet events) const {
  const std::shared_ptr<rt::Doorbell> bell = host_.control_.sharedDoorbell();
  const Channel::Ends ends{.client = bell.get(), .provider = &host_.serverOf_(provided)};
  auto channel =
      std::make_shared<Channel>(provided.info(), name, "rpc", ends, provided.state(), events);
  channel->clientsBell = bell;
  return channel;
}

kj::Own<rpc::ServantPort> PeerServer::serve(ProvidedBase& provided, const Endpoint& endpoint,
                                            std::shared_ptr<Channel> channel) {
  auto port = kj::refcounted<rpc::ServantPort>(host_.control_, channel, caller_->counters);
  if (mayOnlyRead(endpoint)) port->setReadOnly();
  attach(provided, std::move(channel));
  return port;
}

void PeerServer::attach(ProvidedBase& provided, std::shared_ptr<Channel> channel) {
  provided.attach(channel);
  host_.remember(std::move(channel));
}

}  // namespace suture
