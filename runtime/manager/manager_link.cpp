#include <suture/manager/manager_link.h>
#include <suture/transport/rpc/deadline.h>
#include <suture/transport/tls/keys.h>

#include <algorithm>
#include <cstdio>

namespace suture {
namespace {

using rpc::Link;
using Type = kj::Exception::Type;

constexpr Duration kAnswerLimit = std::chrono::seconds(2);
constexpr Duration kFirstPause = std::chrono::milliseconds(50);
constexpr Duration kLongestPause = std::chrono::milliseconds(250);

const char* keysFor(const rpc::Address& address) {
  return address.kind == rpc::Address::Kind::Tls ? " --keys FOLDER" : "";
}

}  // namespace

ManagerLink::ManagerLink(rpc::ControlThread& control, const rpc::Address& manager,
                         std::string program, rpc::Trust trust)
    : control_(control),
      manager_(manager),
      program_(std::move(program)),
      trust_(std::move(trust)),
      here_(manager) {}

kj::Promise<void> ManagerLink::open(Duration patience) {
  const auto deadline = now() + patience;
  return connect().catch_([this, deadline](kj::Exception&& e) -> kj::Promise<void> {
    if (e.getType() != Type::DISCONNECTED) return kj::mv(e);
    const Duration left = deadline - now();
    if (left <= Duration{0}) {
      return rpc::failure(Type::FAILED, "reach the global manager: " + rpc::describe(e) +
                                            " Start it with: suture-manager --listen " +
                                            manager_.text() + keysFor(manager_));
    }
    return control_.timer()
        .afterDelay(rpc::toKj(std::min(left, kFirstPause)))
        .then([this, deadline] { return open(deadline - now()); });
  });
}

kj::Promise<void> ManagerLink::connect() {
  auto reached = rpc::reach(control_.port(), manager_, trust_, tls::kManagerName, kAnswerLimit);
  return reached.then([this](rpc::ByteStream bytes) {
    here_ = rpc::localAddress(manager_, bytes.socket());
    auto stream = kj::heap<rpc::MessageStream>(control_.port(), kj::mv(bytes));
    auto link = kj::heap<Link>(kj::mv(stream), capnp::rpc::twoparty::Side::CLIENT);
    auto request = link->bootstrap<wire::GlobalManager>().helloRequest();
    request.setVersion(wire::PROTOCOL_VERSION);
    request.setProgram(textOf(program_));
    auto hello = request.send().then([this](auto&& results) -> kj::Promise<void> {
      if (results.isRefused()) return refused(results.getRefused());
      session_ = results.getSession();
      return kj::READY_NOW;
    });
    link_ = kj::mv(link);
    return rpc::within(control_.timer(), kAnswerLimit, kj::mv(hello),
                       "talk to " + manager_.text() +
                           ": what listens there does not answer as a global "
                           "manager. Check the address; if it is right, restart the manager.");
  });
}

kj::Promise<void> ManagerLink::enrol(ProcessRecord process) {
  process_ = std::move(process);
  return enrolAgain().then([this] { keeping_ = keep().eagerlyEvaluate(nullptr); });
}

kj::Promise<void> ManagerLink::enrolAgain() {
  auto request = KJ_REQUIRE_NONNULL(session_).registerRequest();
  toWire(process_, request.initProcess());
  return request.send().then([this](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    process_.generation = results.getGeneration();
    lease_ = results.getLease();
    enrolled_ = true;
    return kj::READY_NOW;
  });
}

kj::Promise<void> ManagerLink::keep() {
  return KJ_REQUIRE_NONNULL(link_)
      ->onDisconnect()
      .then([this] { return comeBack(kFirstPause); })
      .then([this] { return keep(); });
}

kj::Promise<void> ManagerLink::comeBack(Duration pause) {
  enrolled_ = false;
  session_ = nullptr;
  lease_ = nullptr;
  return control_.timer()
      .afterDelay(rpc::toKj(pause))
      .then([this] { return connect(); })
      .then([this] { return enrolAgain(); })
      .catch_(
          [this, pause](kj::Exception&&) { return comeBack(std::min(2 * pause, kLongestPause)); });
}

void ManagerLink::update(std::vector<ComponentRecord> components) {
  process_.components = std::move(components);
  KJ_IF_MAYBE (lease, lease_) {
    auto request = lease->updateRequest();
    toWire(process_.components,
           request.initComponents(static_cast<unsigned>(process_.components.size())));
    // If this fails the link is breaking, and coming back tells the manager everything again.
    control_.spawn(request.send().ignoreResult().catch_([](kj::Exception&&) {}));
  }
}

kj::Promise<ProcessRecord> ManagerLink::resolve(const std::string& process, Duration wait) {
  KJ_IF_MAYBE (session, session_) {
    auto request = session->resolveRequest();
    request.setProcess(textOf(process));
    const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(wait).count();
    request.setWaitMilliseconds(
        static_cast<std::uint32_t>(std::clamp<std::int64_t>(milliseconds, 0, 60'000)));
    return request.send().then([](auto&& results) -> kj::Promise<ProcessRecord> {
      if (results.isRefused()) return refused(results.getRefused());
      return fromWire(results.getFound());
    });
  }
  return rpc::disconnected("find process '" + process + "': the global manager at " +
                           manager_.text() + " is gone. Start it again.");
}

kj::Promise<rpc::ByteStream> ManagerLink::reach(const ProcessRecord& process, Duration deadline) {
  if (process.addresses.empty()) {
    return rpc::failure(Type::FAILED, "process '" + process.name + "' has no address. Restart it.");
  }
  const auto address = rpc::Address::parse(process.addresses.front());
  const bool leavesTls = manager_.kind == rpc::Address::Kind::Tls && address.kind != manager_.kind;
  if (leavesTls || (address.insecure && !manager_.insecure)) {
    return rpc::failure(
        Type::FAILED, "connect to process '" + process.name + "': it listens at " + address.text() +
                          ", and the global manager is reached at " + manager_.text() +
                          ". Start that process with the same address.");
  }
  return rpc::reach(control_.port(), address, trust_, process.name, deadline);
}

kj::Promise<std::vector<ProcessRecord>> ManagerLink::list() {
  KJ_IF_MAYBE (session, session_) {
    return session->listRequest().send().then([](auto&& results) {
      std::vector<ProcessRecord> all;
      for (const auto process : results.getProcesses()) all.push_back(fromWire(process));
      return all;
    });
  }
  return rpc::disconnected("list processes: the global manager at " + manager_.text() +
                           " is gone. Start it again.");
}

}  // namespace suture
