#include <suture/codec/stamps.h>
#include <suture/component/task/task.h>
#include <suture/names/describe.h>
#include <suture/session/boot_id.h>
#include <suture/session/provider/acceptance.h>
#include <suture/session/provider/connection_states.h>
#include <suture/session/provider/explain.h>
#include <suture/session/provider/peer_server.h>
#include <suture/session/provider/plain_client.h>
#include <suture/session/task_activity.h>

#include <algorithm>
#include <utility>

namespace suture {
namespace {

constexpr const char* kSayHello = "what there is here is told to whoever has said hello";

}  // namespace

PeerServer::PeerServer(SharedBySessions& shared, std::shared_ptr<framing::Caller> caller)
    : shared_(shared),
      peer_(shared, caller),
      held_(shared, peer_.name(), peer_.state()),
      lanes_(shared, *this),
      sockets_(shared.sockets, shared.secondSockets, std::move(caller)) {}

// Lanes and sockets go after the connections that use them.
PeerServer::~PeerServer() noexcept(false) { held_.end(); }

kj::Promise<void> PeerServer::hello(HelloContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  results.setProcess(codec::textOf(shared_.directory.process()));
  results.setBootId(codec::textOf(bootId()));
  results.setIncarnation(shared_.incarnation);
  const auto in = context.getParams();
  const Admission& admission = peer_.admission();
  auto refusal = admission.whyNotNames({in.getProcess(), in.getBootId()});
  if (!refusal) refusal = admission.whyNotProcess(codec::stringOf(in.getProcess()));
  if (!refusal) refusal = admission.whyNotVersion(in.getVersion());
  if (refusal) {
    peer_.refuse(*refusal, results.initRefused());
  } else {
    peer_.greet(codec::stringOf(in.getBootId()), in.getIncarnation());
    results.setAccepted();
  }
  results.setSent(toNanoseconds(now()));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::ping(PingContext context) {
  auto results = context.getResults();
  results.setReceived(toNanoseconds(now()));
  const auto in = context.getParams();
  held_.leases().hear(in.getHeard());
  if (in.hasComponents()) {
    if (in.getComponents().size() > HeldConnections::kMost) {
      return peer_.fail("more components are watched than can be connected to");
    }
    for (const auto name : in.getComponents()) {
      if (const auto refusal = peer_.admission().whyNotNames({name})) {
        return peer_.fail(refusal->text);
      }
    }
    watched_.clear();
    for (const auto name : in.getComponents()) watched_.push_back(codec::stringOf(name));
  }
  held_.look();
  putTasks(results);
  results.setSent(held_.leases().answer());
  return kj::READY_NOW;
}

void PeerServer::putTasks(wire::Peer::PingResults::Builder results) const {
  auto tasks = results.initTasks(static_cast<unsigned>(watched_.size()));
  for (unsigned i = 0; i < tasks.size(); ++i) {
    const Component* const component = shared_.directory.findComponent(watched_[i]);
    const Task* const task = component == nullptr ? nullptr : shared_.threads.taskOf(*component);
    toWire(task == nullptr ? TaskActivity::Reading{} : task->activity().read(), tasks[i]);
    if (task != nullptr) tasks[i].setCycles(task->statistics().cycles);
  }
}

kj::Promise<void> PeerServer::describe(DescribeContext context) {
  if (!peer_.caller().known) return peer_.fail(kSayHello);
  context.allowCancellation();  // the process may leave before it publishes
  return shared_.published.reached().then([this, context]() mutable {
    const auto components = describeComponents(shared_.directory);
    toWire(components,
           context.getResults().initComponents(static_cast<unsigned>(components.size())));
    tellConnections(shared_.directory, context.getResults());
  });
}

kj::Promise<void> PeerServer::connect(ConnectContext context) {
  auto acceptance = kj::heap<Acceptance>(peer_, held_, lanes_, context);
  auto answered = acceptance->answer();
  return answered.attach(kj::mv(acceptance));
}

kj::Promise<void> PeerServer::open(OpenContext context) {
  return openForPlainClient(peer_, held_, context);
}

kj::Promise<void> PeerServer::explain(ExplainContext context) {
  if (!peer_.caller().known) return peer_.fail(kSayHello);
  const auto in = context.getParams();
  const Endpoint endpoint = peer_.endpoint(in.getComponent(), in.getInterface());
  const bool required = in.getSide() == wire::Peer::Side::REQUIRED;
  const auto withheld = peer_.admission().whyNotNames({in.getComponent(), in.getInterface()});
  return peer_.serve(
      context, withheld, [this, context, endpoint, required]() mutable -> kj::Promise<void> {
        const InterfaceInfo& info = required ? shared_.directory.required(endpoint).info()
                                             : shared_.directory.provided(endpoint).info();
        suture::explain(info, context.getResults().initExplained());
        return kj::READY_NOW;
      });
}

kj::Promise<void> PeerServer::compared(ComparedContext context) {
  const auto in = context.getParams();
  PeerState& state = *peer_.state();
  state.clockShift = -Duration(codec::bounded(in.getClockOffset()));
  state.clockError = Duration(std::max<std::int64_t>(codec::bounded(in.getClockError()), 1));
  return kj::READY_NOW;
}

kj::Promise<void> PeerServer::socket(SocketContext context) {
  if (!peer_.caller().known) {
    return peer_.fail("a second connection is for whoever has said hello");
  }
  context.allowCancellation();  // the process may leave before it publishes
  return lanes_.named(codec::stringOf(context.getParams().getLane()))
      .then([this, context](LaneServer* lane) mutable { return awaitSocket(*lane, context); });
}

kj::Promise<void> PeerServer::awaitSocket(LaneServer& lane, SocketContext& context) {
  const auto expected = sockets_.await(lane);
  if (!expected) {
    return peer_.fail("open a second connection to process '" + shared_.directory.process() +
                      "': " + expected.error());
  }
  context.getResults().setNumber(expected->number);
  context.getResults().setToken(
      {reinterpret_cast<const kj::byte*>(expected->token.data()), expected->token.size()});
  return kj::READY_NOW;
}

void PeerServer::cutOff(const std::string& why) {
  peer_.note("talk to process '" + shared_.directory.process() + "': " + why);
}

}  // namespace suture
