#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/loop/deadline.h>
#include <suture/loop/run_to_the_end.h>
#include <suture/names/describe.h>
#include <suture/names/manager_link.h>
#include <suture/names/peer_address.h>
#include <suture/names/registry.h>
#include <suture/names/start_hint.h>
#include <suture/rt/standard_error.h>
#include <suture/session/client/remote_connection.h>
#include <suture/session/client/sessions.h>
#include <suture/session/network.h>
#include <suture/session/provider/peer_host.h>
#include <suture/session/telling.h>
#include <unistd.h>

#include <algorithm>
#include <random>

namespace suture {
namespace {

/// Runs `work` on the control thread, and throws its failure as a SetupError.
template <class Work>
auto run(loop::ControlThread& control, Duration deadline, Work work) {
  try {
    return control.run(deadline, std::move(work));
  } catch (const loop::ControlFailure& failure) {
    throw SetupError(failure.what());
  }
}

constexpr Duration kLocalWork = std::chrono::seconds(10);
// Nobody waits longer than this, and it is short enough to be added to a time.
constexpr Duration kLongestPatience = std::chrono::hours(24 * 365);
// A start that takes longer than this says what it waits for.
constexpr Duration kLongWait = std::chrono::seconds(2);

std::string atMost(Duration patience) {
  const auto seconds = std::chrono::ceil<std::chrono::seconds>(patience).count();
  return "for at most " + std::to_string(seconds) + " s";
}

std::string hostName() {
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

/// Returns a number that distinguishes this start of the process from all others; never 0.
std::uint64_t newIncarnation() {
  std::random_device device;
  return std::max<std::uint64_t>(std::uint64_t{device()} << 32 | device(), 1);
}

}  // namespace

Network::Network(const Directory& directory, const std::string& managerAddress,
                 ServiceThreads& threads, const Telling& telling, Duration patience,
                 const Security& security, std::uint16_t port)
    : directory_(directory),
      threads_(threads),
      telling_(telling),
      managers_(net::parseAddresses(managerAddress)),
      security_(security),
      port_(port),
      incarnation_(newIncarnation()) {
  if (const std::string why = whyNoName(directory_.process()); !why.empty()) {
    throw SetupError(why);
  }
  net::requireKeys(managers_.front(), security_.trust());
  requireHasPorts(managers_.front(), directory_.process(), port_);
  try {
    patience = std::min(patience, kLongestPatience);
    run(control_, patience + kLocalWork, [this, patience] { return join(patience); });
  } catch (const SetupError&) {
    leave();
    throw;
  }
}

Network::~Network() {
  if (const std::string why = leave(); !why.empty()) rt::printUnlessFull(why);
}

// The thread of frame links starts from the control thread, with the first such link, and
// inherits its scheduling.
void Network::schedule(const rt::Scheduling& scheduling) {
  run(control_, kLocalWork, [scheduling] { rt::schedule("the network", scheduling); });
}

void Network::addLane(std::unique_ptr<LaneKind> lane) {
  const std::string name = lane->name();
  if (name == Lane::Auto.name || findLane(lanes_, name) != lanes_.end()) {
    throw SetupError("adding lane '" + name + "'", "there is one of that name",
                     "Give it a name of its own");
  }
  // The control thread may run this after the caller has given up.
  const auto added =
      run(control_, kLocalWork, [this, kept = std::make_shared<decltype(lane)>(std::move(lane))] {
        const bool early = connections_.empty() && !sessions_->any();
        if (early) lanes_.push_back(std::move(*kept));
        return early;
      });
  if (added) return;
  throw SetupError("adding lane '" + name + "'",
                   "this process has connections, whose sessions do not know it",
                   "Add it before the first connection");
}

std::vector<std::string> Network::lanes() const { return laneNames(lanes_); }

void Network::publish() {
  run(control_, kLocalWork, [this, components = describeComponents(directory_)] {
    link_->update(components);
    host_->publish();
  });
}

void Network::connect(PlannedConnection planned) {
  const std::string name = planned.from.toString();
  const Duration patience = std::min(planned.options.patience, kLongestPatience);
  planned.options.patience = patience;
  for (Endpoint* const end : {&planned.from, &planned.to}) {
    if (end->process.empty()) end->process = directory_.process();
  }
  run(control_, patience + kLocalWork, [this, name, planned, patience] {
    const RemoteConnection::Listener listener{
        .made =
            [this, name](std::shared_ptr<Channel> channel) {
              if (news_.connected(name) != nullptr) tellOf(channel->name(), kIsThereAgain);
              news_.made(name, std::move(channel));
            },
        .lost =
            [this, name](const std::string& channel, std::string why) {
              if (!connections_.contains(name)) return;  // the news crossed its end
              tellOf(channel, lossText(why));
              news_.lost(channel, std::move(why));
            },
        .notBack =
            [this](const std::string& channel, std::string why) {
              tellOf(channel, "cannot be made anew: " + why);
              news_.notBack(channel, std::move(why));
            },
        .failed =
            [this](const std::string& channel, const std::string& lane, const std::string& why) {
              rt::printUnlessFull(directory_.process() + ": " + channel +
                                  " cannot travel by lane '" + lane + "': " + plain(why));
            }};
    connections_[name] = std::make_unique<RemoteConnection>(
        *sessions_, planned, listener, ledgerOf(connectionName(planned.from, planned.to)));
    return open(name, planned.to, patience);
  });
}

void Network::tellOf(const std::string& connection, const std::string& what) const {
  telling_.tell("connection '" + connection + "' " + what);
}

kj::Promise<void> Network::open(const std::string& required, const Endpoint& to,
                                Duration patience) {
  const std::string waits = "waits for '" + to.toString() + "' " + atMost(patience) +
                            ". Start process '" + to.process + "' if it does not run";
  // Forget what could not be connected, because it may be gone before this is.
  return tellIfLong(connections_.at(required)->open(), waits)
      .exclusiveJoin(untilGivenUp())
      .catch_([this, required](kj::Exception&& failure) {
        forget(required);
        kj::throwFatalException(kj::mv(failure));
      });
}

void Network::giveUp() {
  control_.post([this] {
    if (givenUp_ != nullptr) givenUp_->reach();
  });
}

void Network::disconnect(const std::string& required) {
  run(control_, kLocalWork, [this, required] {
    connections_.at(required)->end();
    forget(required);
  });
}

std::string Network::missingManager() const { return link_->missing(); }

std::map<std::string, std::string> Network::managerTroubles() const { return link_->troubles(); }

std::string Network::leave() {
  std::string why = endThere();
  for (const auto& lane : lanes_) lane->stop();
  return why;
}

net::Refusals::Summary Network::refusals() const {
  return host_ == nullptr ? net::Refusals::Summary{} : host_->refusals();
}

std::vector<std::shared_ptr<Channel>> Network::served() const {
  return host_ == nullptr ? std::vector<std::shared_ptr<Channel>>{} : host_->served();
}

kj::Promise<void> Network::join(Duration patience) {
  givenUp_ = std::make_unique<loop::Milestone>();
  const auto tellOfManager = [this](const net::Address& manager, const std::string& trouble) {
    telling_.tell("the global manager at " + manager.text() + " " +
                  (trouble.empty() ? kIsThereAgain : trouble));
  };
  link_ = std::make_unique<ManagerLink>(control_, managers_, directory_.process(),
                                        security_.trust(), tellOfManager);
  sessions_ = std::make_unique<Sessions>(control_, *link_, lanes_,
                                         SessionIdentity{directory_.process(), incarnation_});
  const std::string waits = "waits for a global manager " + atMost(patience) + ". " +
                            howToStartManager(managers_.front());
  return tellIfLong(link_->open(patience), waits).then([this] {
    host_ = listen();
    return link_->enrol({.name = directory_.process(),
                         .addresses = {host_->address().text()},
                         .pid = getpid(),
                         .host = hostName(),
                         .components = {},
                         .generation = 0});
  });
}

// Says which process is to have a port that it cannot have.
std::unique_ptr<PeerHost> Network::listen() {
  const std::string& process = directory_.process();
  try {
    return std::make_unique<PeerHost>(
        ServingProcess{control_, lanes_, directory_, threads_, incarnation_, security_.policy,
                       security_.connectionMemory},
        peerAddress(*link_, process, port_), security_.trust());
  } catch (const SetupError& error) {
    if (port_ == 0) throw;
    throw SetupError(portAsked(process, port_) + ": " + error.what());
  }
}

// Ends what belongs to the control thread, in that thread. Returns why it failed; "" if it did
// not.
std::string Network::endThere() {
  const std::string who = directory_.process() + ": waits to end its connections: ";
  return loop::runToTheEnd(control_, who, [this] {
    connections_.clear();
    sessions_.reset();
    if (host_ != nullptr) host_->hangUp();
    return kj::evalLast([this] {
      host_.reset();
      link_.reset();
      givenUp_.reset();
    });
  });
}

kj::Promise<void> Network::tellIfLong(kj::Promise<void> awaited, const std::string& what) {
  auto telling =
      control_.timer()
          .afterDelay(loop::toKj(kLongWait))
          .then([line = directory_.process() + ": " + what] { rt::printUnlessFull(line); })
          .eagerlyEvaluate(nullptr);
  return awaited.attach(kj::mv(telling));
}

// A connection that is taken down and made again keeps its ledger.
std::shared_ptr<Ledger> Network::ledgerOf(const std::string& connection) {
  std::shared_ptr<Ledger> ledger = ledgers_.of("", connection, incarnation_);
  ledgers_.keep("", connection, incarnation_, ledger);
  return ledger;
}

void Network::forget(const std::string& required) {
  connections_.erase(required);
  ledgers_.letGo();
  news_.forget(required);
}

kj::Promise<void> Network::untilGivenUp() {
  return givenUp_->reached().then([]() -> kj::Promise<void> {
    return loop::failure(kj::Exception::Type::FAILED,
                         "this process has been told to end while it waited. Start it again.");
  });
}

}  // namespace suture
