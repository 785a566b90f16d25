#include "cli/peer/peer.h"
#include <suture/codec/stamps.h>
#include <suture/names/peer_address.h>
#include <suture/session/boot_id.h>
#include <suture/session/client/sessions.h>
#include "cli/peer/wait.h"

namespace suture::cli {
namespace {

/// Returns a better failure if the peer is older than a question and so does not know it.
kj::Exception orTooOld(kj::Exception&& failure, const std::string& process) {
  if (failure.getType() != kj::Exception::Type::UNIMPLEMENTED) return kj::mv(failure);
  return loop::failure(kj::Exception::Type::FAILED,
                       "ask process '" + process +
                           "' what it is: its Suture is older than that question. Rebuild it.");
}

}  // namespace

Peer::Peer(loop::EventPort& loop, ProcessRecord process, const net::Address& manager,
           const Options& options)
    : loop_(loop),
      process_(std::move(process)),
      patience_(options.patience),
      trust_(options.trust),
      address_(addressOf(process_, manager)) {}

void Peer::knock() { cli::knock(loop_, address_, patience_); }

void Peer::dial() {
  Reached reached = cli::reach(loop_, address_, trust_, process_.name, patience_);
  link_ = kj::mv(reached.link);
  certificatesEnd_ = std::move(reached.certificatesEnd);
  peer_ = link_->bootstrap<wire::Peer>();
}

void Peer::greet() {
  auto request = peer_.helloRequest();
  request.setVersion(wire::PROTOCOL_VERSION);
  request.setProcess(kOwnName);
  request.setBootId(codec::textOf(bootId()));
  auto answer = request.send().then([this, asked = now()](auto&& results) -> kj::Promise<void> {
    if (results.isRefused()) return refused(results.getRefused());
    const bool oneClock = codec::stringOf(results.getBootId()) == bootId();
    clock_ = oneClock ? ClockOffset::none() : ClockOffset();
    if (!oneClock) clock_.add(asked, results.getReceived(), results.getSent(), now());
    return kj::READY_NOW;
  });
  wait(loop_, patience_, kj::mv(answer), noAnswerOf(process_.name));
}

Description Peer::describe() {
  auto answer = peer_.describeRequest().send().then([this](auto&& results) {
    Description found{fromWire(results.getComponents()), std::nullopt};
    if (!results.hasConnections()) return found;
    found.connections.emplace();
    for (const auto one : results.getConnections()) {
      found.connections->push_back({.component = codec::stringOf(one.getComponent()),
                                    .required = codec::stringOf(one.getRequired()),
                                    .provided = codec::stringOf(one.getProvided()),
                                    .lane = codec::stringOf(one.getLane()),
                                    .status = codec::stringOf(one.getStatus()),
                                    .age = now() - here(one.getSince()),
                                    .awaitsOperator = one.getAwaitsOperator()});
    }
    return found;
  });
  return wait(loop_, patience_, kj::mv(answer), noAnswerOf(process_.name));
}

Cycle Peer::cycleOf(const std::string& component) {
  auto request = peer_.pingRequest();
  request.initComponents(1).set(0, codec::textOf(component));
  auto answer = request.send().then([](auto&& results) {
    const auto tasks = results.getTasks();
    if (tasks.size() == 0) return Cycle{};
    return Cycle{tasks[0].getActivity() == wire::TaskActivity::Activity::RUNNING,
                 tasks[0].getCycles()};
  });
  return wait(loop_, patience_, kj::mv(answer), noAnswerOf(process_.name));
}

// A refusal is an answer too, and onDisconnect() tells that the link has ended.
kj::Promise<void> Peer::whenSilent() {
  return loop_.getTimer().afterDelay(loop::toKj(patience_)).then([this] {
    auto answer = peer_.pingRequest().send().ignoreResult().catch_([](kj::Exception&&) {});
    return loop::within(loop_.getTimer(), patience_, kj::mv(answer), noAnswerOf(process_.name))
        .then([this] { return whenSilent(); });
  });
}

std::shared_ptr<const Contract> Peer::explain(const Target& target, wire::Peer::Side side) {
  auto request = peer_.explainRequest();
  request.setComponent(codec::textOf(target.component));
  request.setInterface(codec::textOf(target.interface));
  request.setSide(side);
  auto answer = request.send().then(
      [&target](auto&& results) -> kj::Promise<std::shared_ptr<const Contract>> {
        if (results.isRefused()) return refused(results.getRefused());
        return std::make_shared<const Contract>(target.toString(), results.getExplained());
      },
      [this](kj::Exception&& failure) -> kj::Promise<std::shared_ptr<const Contract>> {
        return orTooOld(kj::mv(failure), process_.name);
      });
  return wait(loop_, patience_, kj::mv(answer), noAnswerOf(process_.name));
}

capnp::DynamicCapability::Client Peer::open(const Target& target, const Contract& contract) {
  auto request = peer_.openRequest();
  request.setComponent(codec::textOf(target.component));
  request.setInterface(codec::textOf(target.interface));
  using Opened = capnp::DynamicCapability::Client;
  auto answer = request.send().then([&contract](auto&& results) -> kj::Promise<Opened> {
    if (results.isRefused()) return refused(results.getRefused());
    return results.getContract().template castAs<capnp::DynamicCapability>(contract.interface());
  });
  return wait(loop_, patience_, kj::mv(answer), noAnswerOf(process_.name));
}

Time Peer::here(std::int64_t stamp) const {
  return Time(Duration(codec::shifted(stamp, -clock_.offset())));
}

}  // namespace suture::cli
