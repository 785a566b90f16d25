#include <suture/base/errors.h>
#include <suture/base/plain.h>
#include <suture/lane/lanes.h>
#include <suture/loop/deadline.h>
#include <suture/loop/run_to_the_end.h>
#include <suture/names/describe.h>
#include <suture/names/manager_link.h>
#include <suture/names/peer_address.h>
#include <suture/names/registry.h>
#include <suture/names/start_hint.h>
#include <suture/rt/standard_error.h>
#include <suture/session/client/remote_connection.h>
#include <suture/session/ledgers.h>
#include <suture/session/network.h>
#include <suture/session/provider/peer_host.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
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

class Network::Impl {
 public:
  Impl(const Directory& directory, const std::string& managerAddress, ServiceThreads& threads,
       Duration patience, const Security& security, std::uint16_t port)
      : directory_(directory),
        threads_(threads),
        managers_(net::parseAddresses(managerAddress)),
        security_(security),
        port_(port) {
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

  ~Impl() {
    if (const std::string why = leave(); !why.empty()) rt::printUnlessFull(why);
  }

  // The thread of frame links starts from the control thread, with the first such link, and
  // inherits its scheduling.
  void schedule(const rt::Scheduling& scheduling) {
    run(control_, kLocalWork, [scheduling] { rt::schedule("the network", scheduling); });
  }

  void addLane(std::unique_ptr<LaneKind> lane) {
    const std::string name = lane->name();
    if (name == Lane::Auto.name || findLane(lanes_, name) != lanes_.end()) {
      throw SetupError("adding lane '" + name + "'", "there is one of that name",
                       "Give it a name of its own");
    }
    const bool added = run(control_, kLocalWork, [this, &lane] {
      const bool early = connections_.empty() && !sessions_->any();
      if (early) lanes_.push_back(std::move(lane));
      return early;
    });
    if (added) return;
    throw SetupError("adding lane '" + name + "'",
                     "this process has connections, whose sessions do not know it",
                     "Add it before the first connection");
  }

  std::vector<std::string> lanes() const { return laneNames(lanes_); }

  void publish() {
    run(control_, kLocalWork, [this, components = describeComponents(directory_)] {
      link_->update(components);
      host_->publish();
    });
  }

  void connect(RequiredBase& required, Endpoint from, Endpoint to, ConnectOptions options,
               DelayThread* delays, std::shared_ptr<ConnectionWatch> watch) {
    const std::string name = from.toString();
    options.patience = std::min(options.patience, kLongestPatience);
    if (from.process.empty()) from.process = directory_.process();
    if (to.process.empty()) to.process = directory_.process();
    run(control_, options.patience + kLocalWork, [=, this, &required] {
      const RemoteConnection::Listener listener{
          .made =
              [this, name](std::shared_ptr<Channel> channel) {
                std::lock_guard lock(mutex_);
                whyNotBack_.erase(channel->name());
                connected_[name] = std::move(channel);
              },
          .lost =
              [this, name](const std::string& channel, std::string why) {
                if (!connections_.contains(name)) return;  // the news crossed its end
                std::lock_guard lock(mutex_);
                whyLost_[channel] = std::move(why);
                whyNotBack_.erase(channel);
              },
          .notBack =
              [this](const std::string& channel, std::string why) {
                std::lock_guard lock(mutex_);
                whyNotBack_[channel] = std::move(why);
              },
          .failed =
              [this](const std::string& channel, const std::string& lane, const std::string& why) {
                rt::printUnlessFull(directory_.process() + ": " + channel +
                                    " cannot travel by lane '" + lane + "': " + plain(why));
              }};
      auto begun = std::make_unique<RemoteConnection>(control_, *sessions_, lanes_, required, from,
                                                      to, options, listener, delays, watch,
                                                      ledgerOf(connectionName(from, to)));
      auto& connection = connections_[name] = std::move(begun);
      const std::string waits = "waits for '" + to.toString() + "' " + atMost(options.patience) +
                                ". Start process '" + to.process + "' if it does not run";
      // Forget what could not be connected, because it may be gone before this is.
      return tellIfLong(connection->open(), waits)
          .exclusiveJoin(untilGivenUp())
          .catch_([this, name](kj::Exception&& failure) {
            forget(name);
            kj::throwFatalException(kj::mv(failure));
          });
    });
  }

  void giveUp() {
    control_.post([this] {
      if (giveUp_.get() != nullptr) giveUp_->fulfill();
    });
  }

  void disconnect(const std::string& required) {
    run(control_, kLocalWork, [this, &required] {
      connections_.at(required)->end();
      forget(required);
    });
  }

  std::string missingManager() const { return link_->missing(); }

  std::map<std::string, std::shared_ptr<Channel>> connected() const {
    std::lock_guard lock(mutex_);
    return connected_;
  }

  std::shared_ptr<Channel> connected(const std::string& required) const {
    std::lock_guard lock(mutex_);
    const auto found = connected_.find(required);
    return found == connected_.end() ? nullptr : found->second;
  }

  std::map<std::string, std::string> whyLost() const {
    std::lock_guard lock(mutex_);
    return whyLost_;
  }

  std::map<std::string, std::string> whyNotBack() const {
    std::lock_guard lock(mutex_);
    return whyNotBack_;
  }

  std::string leave() {
    std::string why = endThere();
    for (const auto& lane : lanes_) lane->stop();
    return why;
  }

  std::uint64_t incarnation() const { return incarnation_; }

  net::Refusals::Summary refusals() const {
    return host_ == nullptr ? net::Refusals::Summary{} : host_->refusals();
  }

  std::vector<std::shared_ptr<Channel>> served() const {
    return host_ == nullptr ? std::vector<std::shared_ptr<Channel>>{} : host_->served();
  }

 private:
  kj::Promise<void> join(Duration patience) {
    auto givenUp = kj::newPromiseAndFulfiller<void>();
    givenUp_ = givenUp.promise.fork();
    giveUp_ = kj::mv(givenUp.fulfiller);
    link_ =
        std::make_unique<ManagerLink>(control_, managers_, directory_.process(), security_.trust());
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
  std::unique_ptr<PeerHost> listen() {
    const std::string& process = directory_.process();
    try {
      return std::make_unique<PeerHost>(control_, lanes_, directory_, threads_, incarnation_,
                                        peerAddress(*link_, process, port_), security_);
    } catch (const SetupError& error) {
      if (port_ == 0) throw;
      throw SetupError(portAsked(process, port_) + ": " + error.what());
    }
  }

  // Ends what belongs to the control thread, in that thread. Returns why it failed; "" if it did
  // not.
  std::string endThere() {
    const std::string who = directory_.process() + ": waits to end its connections: ";
    return loop::runToTheEnd(control_, who, [this] {
      connections_.clear();
      sessions_.reset();
      if (host_ != nullptr) host_->hangUp();
      return kj::evalLast([this] {
        host_.reset();
        link_.reset();
        givenUp_ = nullptr;
        giveUp_ = nullptr;
      });
    });
  }

  kj::Promise<void> tellIfLong(kj::Promise<void> awaited, const std::string& what) {
    auto telling =
        control_.timer()
            .afterDelay(loop::toKj(kLongWait))
            .then([line = directory_.process() + ": " + what] { rt::printUnlessFull(line); })
            .eagerlyEvaluate(nullptr);
    return awaited.attach(kj::mv(telling));
  }

  // A connection that is taken down and made again keeps its ledger.
  std::shared_ptr<Ledger> ledgerOf(const std::string& connection) {
    std::shared_ptr<Ledger> ledger = ledgers_.of("", connection, incarnation_);
    ledgers_.keep("", connection, incarnation_, ledger);
    return ledger;
  }

  void forget(const std::string& required) {
    connections_.erase(required);
    ledgers_.letGo();
    const std::lock_guard lock(mutex_);
    const auto found = connected_.find(required);
    if (found == connected_.end()) return;
    whyLost_.erase(found->second->name());
    whyNotBack_.erase(found->second->name());
    connected_.erase(found);
  }

  kj::Promise<void> untilGivenUp() {
    return givenUp_.addBranch().then([]() -> kj::Promise<void> {
      return loop::failure(kj::Exception::Type::FAILED,
                           "this process has been told to end while it waited. Start it again.");
    });
  }

  const Directory& directory_;
  ServiceThreads& threads_;
  const std::vector<net::Address> managers_;  // all of one kind
  const Security security_;
  const std::uint16_t port_;  // 0: the kernel takes one
  const std::uint64_t incarnation_ = newIncarnation();
  loop::ControlThread control_;
  Lanes lanes_ = makeLanes();
  std::unique_ptr<ManagerLink> link_;
  std::unique_ptr<Sessions> sessions_;
  std::unique_ptr<PeerHost> host_;
  kj::ForkedPromise<void> givenUp_{nullptr};
  kj::Own<kj::PromiseFulfiller<void>> giveUp_;
  Ledgers ledgers_{ConnectionEnd::Client};
  std::map<std::string, std::unique_ptr<RemoteConnection>> connections_;  // by required interface
  mutable std::mutex mutex_;  // never taken by a task thread
  std::map<std::string, std::shared_ptr<Channel>> connected_;
  std::map<std::string, std::string> whyLost_, whyNotBack_;
};

Network::Network(const Directory& directory, const std::string& managerAddress,
                 ServiceThreads& threads, Duration patience, const Security& security,
                 std::uint16_t port)
    : impl_(std::make_unique<Impl>(directory, managerAddress, threads, patience, security, port)) {}

Network::~Network() = default;

std::string Network::leave() { return impl_->leave(); }

void Network::schedule(const rt::Scheduling& scheduling) { impl_->schedule(scheduling); }

void Network::publish() { impl_->publish(); }

void Network::addLane(std::unique_ptr<LaneKind> lane) { impl_->addLane(std::move(lane)); }

std::vector<std::string> Network::lanes() const { return impl_->lanes(); }

void Network::connect(RequiredBase& required, const Endpoint& from, const Endpoint& to,
                      const ConnectOptions& options, DelayThread* delays,
                      std::shared_ptr<ConnectionWatch> watch) {
  impl_->connect(required, from, to, options, delays, std::move(watch));
}

void Network::disconnect(const std::string& required) { impl_->disconnect(required); }

void Network::giveUp() { impl_->giveUp(); }

std::string Network::missingManager() const { return impl_->missingManager(); }

std::map<std::string, std::shared_ptr<Channel>> Network::connected() const {
  return impl_->connected();
}

std::shared_ptr<Channel> Network::connected(const std::string& required) const {
  return impl_->connected(required);
}

std::map<std::string, std::string> Network::whyLost() const { return impl_->whyLost(); }

std::map<std::string, std::string> Network::whyNotBack() const { return impl_->whyNotBack(); }

std::uint64_t Network::incarnation() const { return impl_->incarnation(); }

net::Refusals::Summary Network::refusals() const { return impl_->refusals(); }

std::vector<std::shared_ptr<Channel>> Network::served() const { return impl_->served(); }

}  // namespace suture
