#include <suture/codec/stamps.h>
#include <suture/codec/tallies.h>
#include <suture/component/task/task.h>
#include <suture/lane/rpc/calls_server.h>
#include <suture/lane/rpc/servant.h>
#include <suture/loop/failure.h>
#include <suture/names/describe.h>
#include <suture/rt/state/state_table.h>
#include <suture/session/boot_id.h>
#include <suture/session/provider/connection_states.h>
#include <suture/session/provider/explain.h>
#include <suture/session/provider/notices_sender.h>
#include <suture/session/provider/peer_server.h>
#include <suture/session/task_activity.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/frames.h>
#include <suture/wiring/memory_layout.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;
using Type = kj::Exception::Type;

// This is bounded, because each connection has its own mailbox for as long as the session lives.
constexpr std::size_t kMostConnections = 1024;

constexpr const char* kSayHello = "what there is here is told to whoever has said hello";

// Bounds what a client may say, so that sums with it do not overflow.
Duration silenceIn(wire::ConnectRequest::Reader request) {
  constexpr Duration kLongest = std::chrono::hours(24 * 365);
  return std::clamp(Duration(request.getSilence()), Duration{0}, kLongest);
}

/// Ends the connection when the client drops it.
class ConnectionServer final : public wire::Connection::Server {
 public:
  explicit ConnectionServer(kj::Own<ProviderEnd> end) : end_(kj::mv(end)) {}
  ~ConnectionServer() noexcept(false) { end_->close(); }

 private:
  kj::Own<ProviderEnd> end_;
};

}  // namespace

PeerServer::PeerServer(PeerHost& host, std::shared_ptr<framing::Caller> caller)
    : host_(host),
      caller_(std::move(caller)),
      admission_(host.directory_.process(), host.policy_, caller_->identity),
      interfaces_(kMostConnections),
      leases_(host.control_, state_),
      sockets_(host.sockets_, host.secondSockets_, caller_) {}

PeerServer::~PeerServer() noexcept(false) {
  for (Held& held : held_) {
    host_.latest_.forget(*held.end);
    held.end->close();
  }
}

kj::Promise<void> PeerServer::hello(HelloContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  results.setProcess(codec::textOf(host_.directory_.process()));
  results.setBootId(codec::textOf(bootId()));
  results.setIncarnation(host_.incarnation_);
  const auto in = context.getParams();
  auto refusal = admission_.whyNotNames({in.getProcess(), in.getBootId()});
  if (!refusal) refusal = admission_.whyNotProcess(codec::stringOf(in.getProcess()));
  if (!refusal) refusal = admission_.whyNotVersion(in.getVersion());
  if (refusal) {
    refuse(*refusal, results.initRefused());
  } else {
    bootId_ = codec::stringOf(in.getBootId());
    incarnation_ = in.getIncarnation();
    greeting_ = host_.latest_.nextGreeting();
    caller_->known = true;
    results.setAccepted();
  }
  results.setSent(toNanoseconds(now()));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::ping(PingContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  const auto in = context.getParams();
  leases_.hear(in.getHeard());
  if (in.hasComponents()) {
    if (in.getComponents().size() > kMostConnections) {
      return fail("more components are watched than can be connected to");
    }
    for (const auto name : in.getComponents()) {
      if (const auto refusal = admission_.whyNotNames({name})) return fail(refusal->text);
    }
    watched_.clear();
    for (const auto name : in.getComponents()) watched_.push_back(codec::stringOf(name));
  }
  // A client that leaves may have sent this before its connections ended, which travel on sockets
  // of their own; it stays if it says more after that.
  if (std::exchange(anyEnded_, forgetEnded())) host_.forgetClosed();
  for (Held& held : held_) held.end->tellEarlier();
  putTasks(results);
  results.setSent(leases_.answer());
  return kj::READY_NOW;
}

void PeerServer::putTasks(wire::Peer::PingResults::Builder results) const {
  auto tasks = results.initTasks(static_cast<unsigned>(watched_.size()));
  for (unsigned i = 0; i < tasks.size(); ++i) {
    const Component* const component = host_.directory_.findComponent(watched_[i]);
    const Task* const task = component == nullptr ? nullptr : host_.threads_.taskOf(*component);
    toWire(task == nullptr ? TaskActivity::Reading{} : task->activity().read(), tasks[i]);
    if (task != nullptr) tasks[i].setCycles(task->statistics().cycles);
  }
}

kj::Promise<void> PeerServer::describe(DescribeContext context) {
  if (!caller_->known) return fail(kSayHello);
  context.allowCancellation();  // the process may leave before it publishes
  return host_.whenPublished_.addBranch().then([this, context]() mutable {
    const auto components = describeComponents(host_.directory_);
    toWire(components,
           context.getResults().initComponents(static_cast<unsigned>(components.size())));
    tellConnections(host_.directory_, context.getResults());
  });
}

void PeerServer::refuse(const Refusal& refusal, wire::Refusal::Builder out) {
  host_.refusals_.add(caller_->identity.text(), refusal.text);
  toWire(refusal, out);
}

kj::Promise<void> PeerServer::fail(const std::string& why) {
  host_.refusals_.add(caller_->identity.text(), why);
  return loop::failure(Type::FAILED, why);
}

template <class Attempt, class Refuse>
kj::Promise<void> PeerServer::whenThere(Attempt attempt, Refuse refuse) {
  try {
    return attempt();
  } catch (const SetupError&) {
    // The interface may still come, since the process may still be adding components.
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

std::optional<Refusal> PeerServer::whyNotGiven(const Endpoint& endpoint) {
  if (forgetEnded()) host_.forgetClosed();
  if (interfaces_.anyFree()) return admission_.whyNotInterface(endpoint);
  return Refusal{Kind::LIMIT_REACHED, "use '" + endpoint.toString() +
                                          "': this process has been given " +
                                          std::to_string(kMostConnections) +
                                          " interfaces, and none is given more. Let go of some."};
}

std::optional<Refusal> PeerServer::whyNoMemory(const Endpoint& endpoint,
                                               const ChannelMemory::Share& share,
                                               std::size_t bytes) {
  auto beyond = host_.memory_.hold(share, bytes);
  if (beyond) {
    host_.forgetClosed();  // they are kept for reports only
    host_.sweep();
    beyond = host_.memory_.hold(share, bytes);
  }
  if (!beyond) return std::nullopt;
  return Refusal{Kind::LIMIT_REACHED,
                 "use '" + endpoint.toString() + "': the connection would take " +
                     std::to_string(bytes) + " bytes, and of the " + std::to_string(beyond->limit) +
                     " for the connections of " + beyond->whose + " " +
                     std::to_string(beyond->left) +
                     " are left. Let go of some, or give its commands and events shorter queues."};
}

kj::Promise<void> PeerServer::connect(ConnectContext context) {
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getToComponent(), in.getProvided());
  auto withheld = admission_.whyNotNames({in.getFromProcess(), in.getFromComponent(),
                                          in.getRequired(), in.getToComponent(), in.getProvided(),
                                          in.getContract(), in.getHash()});
  if (!withheld) withheld = admission_.whyNotProcess(codec::stringOf(in.getFromProcess()));
  if (!withheld) withheld = whyNotGiven(endpoint);
  if (withheld) {
    refuse(*withheld, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  caller_->known = true;
  context.allowCancellation();  // a client that gives up and asks anew takes one place
  return whenThere(
      [this, context, endpoint, place = interfaces_.take()]() mutable {
        return decide(host_.directory_.provided(endpoint), endpoint, context, place);
      },
      [this, context](const Refusal& refusal) mutable {
        refuse(refusal, context.getResults().initRefused());
      });
}

/// This is an attempt to connect that may be accepted.
struct PeerServer::ConnectAttempt {
  std::string client;  // the required interface, as Admission::proven() returns it
  IncomingConnection connection;
  Match match;
  ConnectContext context;
  Places::Place place;
  ChannelMemory::Share memory;
};

kj::Promise<void> PeerServer::decide(ProvidedBase& provided, const Endpoint& endpoint,
                                     ConnectContext& context, Places::Place place) {
  auto in = context.getParams();
  const Endpoint client{codec::stringOf(in.getFromProcess()),
                        codec::stringOf(in.getFromComponent()), codec::stringOf(in.getRequired())};
  const std::string name = connectionName(client, endpoint);
  const std::string contract = codec::stringOf(in.getContract()),
                    hash = codec::stringOf(in.getHash()),
                    description = codec::stringOf(in.getDescription());
  try {
    const Match match = requireCompatibleContract(describedInfo(contract, hash, description),
                                                  provided.info(), name);
    requireSameFrames(fromWire(in.getFrames()), provided.frames(), name);
    const std::string caller = admission_.proven(client.toString());
    if (in.getEpoch() == 0 || mayTakeOver(caller, name, context)) {
      return accept(
          {.client = caller,
           .connection = {.provided = provided,
                          .contract = *match.contract,
                          .terms = {.name = name,
                                    .ledger = host_.ledgers_.of(caller_->identity.text(), name,
                                                                incarnation_)},
                          .events = fromWireNumbers(match.contract->wireEvents, in.getEvents()),
                          .provider = host_.threads_.serverOf(provided),
                          .readOnly = admission_.mayOnlyRead(endpoint),
                          .peer = state_,
                          .silence = silenceIn(in)},
           .match = match,
           .context = context,
           .place = std::move(place),
           .memory = host_.memory_.share(caller_->identity.text())});
    }
    return kj::READY_NOW;
  } catch (const SetupError& error) {
    refuse({Kind::CONTRACT_MISMATCH, error.what()}, context.getResults().initRefused());
    return kj::READY_NOW;
  }
}

PeerHost::Latest PeerServer::latestAt(ConnectContext& context, ProviderEnd* end) const {
  return {.bootId = bootId_,
          .epoch = context.getParams().getEpoch(),
          .incarnation = incarnation_,
          .greeting = greeting_,
          .end = end};
}

// One required interface has one connection: the latest.
bool PeerServer::mayTakeOver(const std::string& client, const std::string& name,
                             ConnectContext& context) {
  const std::string why = host_.latest_.whySuperseded(client, name, latestAt(context, nullptr));
  if (why.empty()) return true;
  refuse({Kind::ALREADY_CONNECTED, why}, context.getResults().initRefused());
  return false;
}

kj::Promise<void> PeerServer::accept(const ConnectAttempt& attempt) {
  ConnectContext context = attempt.context;
  return whenLane(codec::stringOf(context.getParams().getLane()))
      .then([this, attempt](LaneServer* lane) { return make(*lane, attempt); })
      .then(
          [this, attempt](kj::Maybe<AcceptedEnd>&& made) {
            KJ_IF_MAYBE (end, made) accepted(attempt, kj::mv(*end));
          },
          [this, context](kj::Exception&& why) { decline(context, why); });
}

void PeerServer::decline(ConnectContext context, const kj::Exception& why) {
  const auto in = context.getParams();
  const std::string text = loop::describe(why);
  context.getResults().setDeclined(codec::textOf(text));
  if (why.getType() != Type::OVERLOADED) return;
  context.getResults().setFailed(true);
  host_.refusals_.add(caller_->identity.text(),
                      "use '" + endpointOf(in.getToComponent(), in.getProvided()).toString() +
                          "' by lane '" + codec::stringOf(in.getLane()) + "': " + text);
}

kj::Promise<kj::Maybe<AcceptedEnd>> PeerServer::make(LaneServer& lane,
                                                     const ConnectAttempt& attempt) {
  ConnectContext context = attempt.context;
  const auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getToComponent(), in.getProvided());
  if (const auto refusal =
          whyNoMemory(endpoint, attempt.memory, lane.bytesFor(attempt.connection))) {
    refuse(*refusal, context.getResults().initRefused());
    return kj::Maybe<AcceptedEnd>();
  }
  auto answer = context.getResults().initAccepted().initAnswer();
  return lane.accept(attempt.connection, in.getBrings(), answer).then([](AcceptedEnd&& end) {
    return kj::Maybe<AcceptedEnd>(kj::mv(end));
  });
}

// The process may still be adding lanes until it publishes.
kj::Promise<LaneServer*> PeerServer::whenLane(const std::string& name) {
  if (LaneServer* const lane = laneNamed(name)) return lane;
  return host_.whenPublished_.addBranch().then([this, name]() -> kj::Promise<LaneServer*> {
    if (LaneServer* const lane = laneNamed(name)) return lane;
    return loop::failure(Type::FAILED, "the provider's process has no lane '" + name + "'");
  });
}

LaneServer* PeerServer::laneNamed(const std::string& name) {
  if (const auto found = lanes_.find(name); found != lanes_.end()) return found->second.get();
  const auto kind = findLane(host_.lanes_, name);
  if (kind == host_.lanes_.end()) return nullptr;
  return lanes_.emplace(name, (*kind)->makeServer(*this)).first->second.get();
}

// Another attempt of the same interface may have come while the lane was getting ready. Stores the
// end before it becomes the latest, because what the caller sent may be invalid and throw.
void PeerServer::accepted(const ConnectAttempt& attempt, AcceptedEnd accepted) {
  ConnectContext context = attempt.context;
  const auto in = context.getParams();
  ProviderEnd& end = *accepted.end;
  if (in.getEpoch() != 0) {
    if (!mayTakeOver(attempt.client, attempt.connection.terms.name, context)) return end.close();
    host_.latest_.end(attempt.client);
  }
  const std::shared_ptr<Ledger>& ledger = accepted.channel->terms.ledger;
  host_.ledgers_.keep(caller_->identity.text(), attempt.connection.terms.name, incarnation_,
                      ledger);
  ledger->begin(accepted.channel, incarnation_);
  end.setListener(kj::heap<NoticesSender>(host_.control_, in.getNotices()));
  host_.memory_.keep(accepted.channel, attempt.memory);
  keep({kj::addRef(end), accepted.channel, attempt.place});
  if (in.getEpoch() != 0) host_.latest_.set(attempt.client, latestAt(context, &end));
  auto out = context.getResults().getAccepted();
  out.setLacking(kj::arrayPtr(attempt.match.lacking.data(), attempt.match.lacking.size()));
  out.setRows(static_cast<std::uint32_t>(attempt.connection.provided.state()->capacity()));
  codec::toWire(end.earlier(), out.initEarlier());
  out.setConnection(kj::heap<ConnectionServer>(kj::addRef(end)));
  attach(attempt.connection.provided, std::move(accepted.channel));
}

void PeerServer::keep(Held held) {
  leases_.watch(*held.end);
  held_.push_back(kj::mv(held));
}

bool PeerServer::forgetEnded() {
  return std::erase_if(held_, [this](const Held& held) {
           const bool over = held.channel->status == ChannelStatus::Closed;
           if (over) host_.latest_.forget(*held.end);
           return over;
         }) > 0;
}

kj::Promise<void> PeerServer::compared(ComparedContext context) {
  const auto in = context.getParams();
  state_->clockShift = -Duration(codec::bounded(in.getClockOffset()));
  state_->clockError = Duration(std::max<std::int64_t>(codec::bounded(in.getClockError()), 1));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::socket(SocketContext context) {
  if (!caller_->known) return fail("a second connection is for whoever has said hello");
  context.allowCancellation();  // the process may leave before it publishes
  return whenLane(codec::stringOf(context.getParams().getLane()))
      .then([this, context](LaneServer* lane) mutable { return awaitSocket(*lane, context); });
}

kj::Promise<void> PeerServer::awaitSocket(LaneServer& lane, SocketContext& context) {
  const auto expected = sockets_.await(lane);
  if (!expected) {
    return fail("open a second connection to process '" + host_.directory_.process() +
                "': it has " + std::to_string(host_.secondSockets_.most()) +
                " of them, and no process has more. End some of its peers.");
  }
  context.getResults().setNumber(expected->number);
  context.getResults().setToken(
      {reinterpret_cast<const kj::byte*>(expected->token.data()), expected->token.size()});
  return kj::READY_NOW;
}

void PeerServer::cutOff(const std::string& why) {
  host_.refusals_.add(caller_->identity.text(),
                      "talk to process '" + host_.directory_.process() + "': " + why);
}

kj::Promise<void> PeerServer::open(OpenContext context) {
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getComponent(), in.getInterface());
  auto withheld = admission_.whyNotNames({in.getComponent(), in.getInterface()});
  if (!withheld) withheld = whyNotGiven(endpoint);
  if (withheld) {
    refuse(*withheld, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  caller_->known = true;
  context.allowCancellation();  // a client that gives up and asks anew takes one place
  return whenThere(
      [this, context, endpoint, place = interfaces_.take()]() mutable -> kj::Promise<void> {
        ProvidedBase& provided = host_.directory_.provided(endpoint);
        const std::string name = "(a plain client) -> " + endpoint.toString();
        const IncomingConnection connection{.provided = provided,
                                            .contract = provided.info(),
                                            .terms = {.name = name},
                                            .events = ~EventSet{0},
                                            .provider = host_.threads_.serverOf(provided),
                                            .readOnly = admission_.mayOnlyRead(endpoint)};
        const ChannelMemory::Share memory = host_.memory_.share(caller_->identity.text());
        const std::size_t bytes = Channel::bytesFor(provided.info());
        if (const auto refusal = whyNoMemory(endpoint, memory, bytes)) {
          refuse(*refusal, context.getResults().initRefused());
          return kj::READY_NOW;
        }
        auto channel = rpc::callsChannel(host_.control_, connection);
        auto port = rpc::serveCalls(host_.control_, connection, channel, caller_->counters);
        host_.memory_.keep(channel, memory);
        keep({kj::addRef(*port), channel, place});
        attach(provided, std::move(channel));
        context.getResults().setContract(kj::heap<rpc::Servant>(kj::mv(port)));
        return kj::READY_NOW;
      },
      [this, context](const Refusal& refusal) mutable {
        refuse(refusal, context.getResults().initRefused());
      });
}

kj::Promise<void> PeerServer::explain(ExplainContext context) {
  if (!caller_->known) return fail(kSayHello);
  auto in = context.getParams();
  const Endpoint endpoint = endpointOf(in.getComponent(), in.getInterface());
  const bool required = in.getSide() == wire::Peer::Side::REQUIRED;
  if (const auto refusal = admission_.whyNotNames({in.getComponent(), in.getInterface()})) {
    refuse(*refusal, context.getResults().initRefused());
    return kj::READY_NOW;
  }
  context.allowCancellation();  // the process may leave before it publishes
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

Endpoint PeerServer::endpointOf(capnp::Text::Reader component,
                                capnp::Text::Reader interface) const {
  return {host_.directory_.process(), codec::stringOf(component), codec::stringOf(interface)};
}

void PeerServer::attach(ProvidedBase& provided, std::shared_ptr<Channel> channel) {
  provided.attach(channel);
  host_.remember(std::move(channel));
}

}  // namespace suture
