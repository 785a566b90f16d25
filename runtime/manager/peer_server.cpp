#include <suture/manager/describe.h>
#include <suture/manager/peer_server.h>
#include <suture/rt/state_table.h>
#include <suture/transport/rpc/stamps.h>
#include <suture/wiring/connect.h>

#include <algorithm>

namespace suture {
namespace {

using Kind = wire::Refusal::Kind;

/// Ends the connection when the client lets go of it.
class ConnectionServer final : public wire::Connection::Server {
 public:
  explicit ConnectionServer(kj::Own<rpc::ServantPort> port) : port_(kj::mv(port)) {}
  ~ConnectionServer() noexcept(false) { port_->close(); }

 private:
  kj::Own<rpc::ServantPort> port_;
};

/// Tells the client what befalls its provider. Whether it hears does not matter here.
class NoticesSender final : public rpc::ServantPort::Listener {
 public:
  NoticesSender(rpc::ControlThread& control, wire::Notices::Client client)
      : control_(control), client_(kj::mv(client)) {}

  void told(ChannelStatus status) override {
    switch (status) {
      case ChannelStatus::Connected: return send(client_.resumedRequest());
      case ChannelStatus::Suspended: return send(client_.suspendedRequest());
      case ChannelStatus::Faulted: return send(client_.faultedRequest());
      case ChannelStatus::Lost:
      case ChannelStatus::Closed: return send(client_.closedRequest());
    }
  }

  void replays(std::uint16_t event, Time stamp) override {
    auto request = client_.replayedRequest();
    request.setEvent(event);
    request.setStamp(toNanoseconds(stamp));
    send(kj::mv(request));
  }

 private:
  template <class Request>
  void send(Request request) {
    control_.spawn(request.send().ignoreResult().catch_([](kj::Exception&&) {}));
  }

  rpc::ControlThread& control_;
  wire::Notices::Client client_;
};

/// What the client requires, as far as a comparison needs it.
InterfaceInfo requiredInfo(const std::string& contract, const std::string& hash,
                           const std::string& description) {
  return {.name = contract.c_str(),
          .hash = hash.c_str(),
          .description = description.c_str(),
          .commands = {},
          .events = {},
          .binding = nullptr};
}

}  // namespace

PeerServer::PeerServer(PeerHost& host, std::shared_ptr<const rpc::LinkCounters> counters)
    : host_(host), counters_(std::move(counters)) {}

PeerServer::~PeerServer() noexcept(false) {
  for (auto& port : ports_) port->close();
}

kj::Promise<void> PeerServer::hello(HelloContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  results.setProcess(textOf(host_.directory_.process()));
  results.setBootId(textOf(bootId()));
  const std::uint16_t theirs = context.getParams().getVersion();
  if (theirs == wire::PROTOCOL_VERSION) {
    results.setAccepted();
  } else {
    toWire({Kind::VERSION_MISMATCH,
            "talk to process '" + host_.directory_.process() + "': it speaks version " +
                std::to_string(wire::PROTOCOL_VERSION) + " of the protocol, the caller version " +
                std::to_string(theirs) + ". Build both from the same release."},
           results.initRefused());
  }
  results.setSent(toNanoseconds(now()));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::ping(PingContext context) {
  context.getResults().setReceived(toNanoseconds(now()));
  context.getResults().setSent(toNanoseconds(now()));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::describe(DescribeContext context) {
  return host_.whenPublished_.addBranch().then([this, context]() mutable {
    const auto components = describeComponents(host_.directory_);
    toWire(components,
           context.getResults().initComponents(static_cast<unsigned>(components.size())));
  });
}

template <class Answer, class Refuse>
kj::Promise<void> PeerServer::withInterface(const Endpoint& endpoint, Answer answer,
                                            Refuse refuse) {
  try {
    answer(host_.directory_.provided(endpoint));
    return kj::READY_NOW;
  } catch (const SetupError&) {
    // It may come: the process is perhaps still adding components.
  }
  return host_.whenPublished_.addBranch().then([this, endpoint, answer, refuse]() mutable {
    try {
      answer(host_.directory_.provided(endpoint));
    } catch (const SetupError& error) {
      refuse(Refusal{Kind::NO_SUCH_INTERFACE, error.what()});
    }
  });
}

kj::Promise<void> PeerServer::connect(ConnectContext context) {
  auto in = context.getParams();
  const Endpoint endpoint{host_.directory_.process(), stringOf(in.getToComponent()),
                          stringOf(in.getProvided())};
  return withInterface(
      endpoint,
      [this, context, endpoint](ProvidedBase& provided) mutable {
        accept(provided, endpoint, context);
      },
      [context](const Refusal& refusal) mutable {
        toWire(refusal, context.getResults().initRefused());
      });
}

void PeerServer::accept(ProvidedBase& provided, const Endpoint& endpoint, ConnectContext& context) {
  auto in = context.getParams();
  const Endpoint client{stringOf(in.getFromProcess()), stringOf(in.getFromComponent()),
                        stringOf(in.getRequired())};
  const std::string name = client.toString() + " -> " + endpoint.toString();
  const std::string contract = stringOf(in.getContract()), hash = stringOf(in.getHash()),
                    description = stringOf(in.getDescription());
  std::size_t offered = 0;
  try {
    offered = requireSameContract(requiredInfo(contract, hash, description), provided.info(), name);
  } catch (const SetupError& error) {
    toWire({Kind::CONTRACT_MISMATCH, error.what()}, context.getResults().initRefused());
    return;
  }
  // A stamp of the caller, minus how far its clock is ahead, is a stamp of ours.
  auto port = serve(provided, name, in.getEvents(), Duration(-rpc::bounded(in.getClockOffset())));
  port->setListener(kj::heap<NoticesSender>(host_.control_, in.getNotices()));
  auto accepted = context.getResults().initAccepted();
  accepted.setOffered(static_cast<std::uint16_t>(offered));
  accepted.setRows(static_cast<std::uint32_t>(provided.state()->capacity()));
  accepted.setConnection(kj::heap<ConnectionServer>(kj::addRef(*port)));
  accepted.setContract(provided.info().binding().makeServant(kj::mv(port)));
}

kj::Promise<void> PeerServer::open(OpenContext context) {
  auto in = context.getParams();
  const Endpoint endpoint{host_.directory_.process(), stringOf(in.getComponent()),
                          stringOf(in.getInterface())};
  return withInterface(
      endpoint,
      [this, context, endpoint](ProvidedBase& provided) mutable {
        const std::string name = "(a plain client) -> " + endpoint.toString();
        auto port = serve(provided, name, ~EventSet{0}, Duration{0});
        context.getResults().setContract(provided.info().binding().makeServant(kj::mv(port)));
      },
      [context](const Refusal& refusal) mutable {
        toWire(refusal, context.getResults().initRefused());
      });
}

kj::Own<rpc::ServantPort> PeerServer::serve(ProvidedBase& provided, const std::string& name,
                                            EventSet events, Duration shift) {
  const std::shared_ptr<rt::Doorbell> bell = host_.control_.sharedDoorbell();
  const Channel::Ends ends{.client = bell.get(), .provider = &host_.serverOf_(provided)};
  auto channel =
      std::make_shared<Channel>(provided.info(), name, "rpc", ends, provided.state(), events);
  channel->clientsBell = bell;
  auto port = kj::refcounted<rpc::ServantPort>(host_.control_, channel, shift, counters_);
  provided.attach(channel);
  host_.remember(std::move(channel));
  ports_.add(kj::addRef(*port));
  return port;
}

}  // namespace suture
