#include <suture/component/channel/channel.h>
#include <suture/component/required.h>
#include <suture/component/task/task.h>
#include <suture/deploy/host.h>
#include <suture/deploy/process/security.h>
#include <suture/lane/lane_kind.h>
#include <suture/lane/lane_refusals.h>
#include <suture/names/peer_address.h>
#include <suture/session/telling.h>

#include <algorithm>
#include <map>
#include <utility>

namespace suture {
namespace {

constexpr std::string_view kConnection = "connection '";

std::string subjectOf(const Channel& channel) {
  return std::string(kConnection) + channel.name() + "'";
}

/// `why` has, by the name of each connection, what its client's end was told: "closed: ...".
std::string lossTextOf(const std::map<std::string, std::string>& why, const std::string& name) {
  const auto told = why.find(name);
  if (told == why.end())
    return "is lost: its provider has been stopped, or the process at its other end is gone. Start "
           "it again";
  return lossText(told->second);
}

}  // namespace

Host::Host(const Deployment& deployment, std::string_view process,
           std::span<const ComponentClass> classes, Duration patience)
    : deployment_(deployment), process_(deployment.process(process)), patience_(patience) {
  std::vector<std::string> problems;
  components_.emplace(deployment_, process_, classes, problems);
  if (!problems.empty()) throw DocumentError(problems);
  faults_.emplace(process_, components_->all());
  realTime_.giveTo(components_->all());
  createManager();
  realTime_.giveTo(*manager_);
}

void Host::createManager() {
  const std::string& address = deployment_.manager();
  const Security ours = securityOf(deployment_, process_, warnings_);
  try {
    manager_ = address.empty() ? std::make_unique<Manager>(process_.name)
                               : std::make_unique<Manager>(process_.name, address, ours, patience_,
                                                           process_.port);
    manager_->tellBy(nullptr);  // troubles() has what it would tell
    for (std::size_t i = 0; i < components().size(); ++i) {
      manager_->add(process_.components[i].name, *components()[i]);
    }
  } catch (const SetupError& error) {
    const std::string_view why = error.what();
    const bool ofPort = why.starts_with(portAsked(process_.name, process_.port));
    throw DocumentError({deployment_.document().locate(
        ofPort ? process_.pointer + "/port" : "/manager", error.what())});
  }
}

void Host::configure() {
  std::vector<std::string> problems;
  manager_->configure();
  for (std::size_t i = 0; i < components().size(); ++i) {
    if (components()[i]->state() != ComponentState::Faulted) continue;
    const ComponentEntry& entry = process_.components[i];
    problems.push_back(deployment_.document().locate(
        entry.pointer, "component '" + entry.name + "' of class '" + entry.className +
                           "' cannot be configured: " + components()[i]->fault()));
  }
  if (!problems.empty()) throw DocumentError(problems);
}

void Host::addLane(std::unique_ptr<LaneKind> lane) { manager_->addLane(std::move(lane)); }

// A deployment may name a lane that only its program knows, so it is this that finds a wrong name.
void Host::requireLanes() const {
  const std::vector<std::string> known = manager_->lanes();
  std::vector<std::string> problems;
  for (const ConnectionEntry& connection : deployment_.connections()) {
    const Lane& lane = connection.options.lane;
    if (connection.from.process != process_.name || lane == Lane::Auto) continue;
    if (std::find(known.begin(), known.end(), lane.name) != known.end()) continue;
    const std::string name = connectionName(connection.from, connection.to);
    problems.push_back(deployment_.document().locate(connection.pointer + "/lane",
                                                     laneUnknown(name, lane, known).what()));
  }
  if (!problems.empty()) throw DocumentError(problems);
}

// This comes before a component runs, which else could take a connection on its way for a missing
// one.
void Host::announceConnections() {
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.from.process != process_.name) continue;
    for (std::size_t i = 0; i < components().size(); ++i) {
      if (process_.components[i].name != connection.from.component) continue;
      for (RequiredBase* required : components()[i]->required()) {
        if (required->name() == connection.from.interface) required->expectConnection();
      }
    }
  }
}

void Host::start() {
  requireLanes();
  announceConnections();
  configure();
  faults_->begin();
  try {
    manager_->start();
  } catch (const SetupError& error) {
    throw DocumentError({deployment_.document().locate("/processes", error.what())});
  }
  if (messages_) messages_->connect(*manager_);
  for (const ConnectionEntry& connection : deployment_.connections()) {
    if (connection.from.process != process_.name) continue;
    const Endpoint from{"", connection.from.component, connection.from.interface};
    try {
      ConnectOptions options = connection.options;
      options.patience = patience_;
      manager_->connect(from.toString(), connection.to.toString(), options);
    } catch (const SetupError& error) {
      throw DocumentError({deployment_.document().locate(connection.pointer, error.what())});
    }
  }
}

void Host::stop() {
  manager_->stop();
  stopped_ = true;
}

// Returns false while it is between a fault and a restart.
bool Host::faultedForGood(const Component& component) const {
  if (component.state() != ComponentState::Faulted) return false;
  return stopped_ || !component.ownsThread() || static_cast<const Task&>(component).staysFaulted();
}

std::vector<std::string> Host::componentNames() const {
  std::vector<std::string> names;
  for (const ComponentEntry& entry : process_.components) names.push_back(entry.name);
  return names;
}

void Host::listenToMessages() {
  messages_.emplace(components());
  manager_->add(MessageListener::kName, *messages_);
}

std::vector<std::string> Host::news() {
  std::vector<std::string> lines = realTime_.news();
  for (std::string& line : std::exchange(warnings_, {})) lines.push_back(std::move(line));
  for (std::string& line : faults_->news()) lines.push_back(std::move(line));
  for (std::string& line : mutualWaits()) lines.push_back(std::move(line));
  if (!messages_) return lines;
  for (std::string& line : messages_->heard()) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> Host::mutualWaits() {
  std::vector<std::string> lines;
  for (const auto& channel : manager_->channels()) {
    if (channel->mutualWaits == 0 || !toldToWait_.insert(channel->name()).second) continue;
    const std::string one(Channel::componentOf(channel->clientName()));
    const std::string other(Channel::componentOf(channel->providerName()));
    lines.push_back(subjectOf(*channel) + ": '" + one + "' waited for '" + other +
                    "' until its deadline, and a command of '" + other + "' waited for '" + one +
                    "', which ends none while it waits. Let one of the two look at its answer "
                    "with poll() or then()");
  }
  return lines;
}

std::vector<Trouble> Host::troubles() const {
  std::vector<Trouble> found = componentTroubles();
  if (stopped_) return found;
  const std::vector<Trouble> connections = connectionTroubles();
  found.insert(found.end(), connections.begin(), connections.end());
  for (const auto& [address, why] : manager_->whyNoGlobalManager()) {
    found.push_back({"the global manager at " + address, why, false});
  }
  return found;
}

std::vector<Trouble> Host::componentTroubles() const {
  std::vector<Trouble> found;
  for (std::size_t i = 0; i < components().size(); ++i) {
    if (!faultedForGood(*components()[i])) continue;
    const ComponentEntry& entry = process_.components[i];
    const bool loss = components()[i]->faultCause() == FaultCause::Connection;
    found.push_back({"component '" + process_.name + ":" + entry.name + "'",
                     "is parked, " + components()[i]->whyFaulted() +
                         (entry.restart ? ". It is restarted no more" : "") +
                         ". Correct the cause and start the process anew",
                     true, loss});
  }
  return found;
}

bool Host::exists(const Trouble& trouble) const {
  if (!trouble.subject.starts_with(kConnection)) return true;
  const std::vector<std::shared_ptr<Channel>> all = manager_->channels();
  return std::any_of(all.begin(), all.end(), [&](const auto& channel) {
    return subjectOf(*channel) == trouble.subject &&
           channel->status.load(std::memory_order_acquire) != ChannelStatus::Closed;
  });
}

std::vector<Trouble> Host::connectionTroubles() const {
  std::vector<Trouble> found;
  const std::map<std::string, std::string> whyLost = manager_->whyLost(),
                                           whyNotBack = manager_->whyNotBack();
  for (const auto& channel : manager_->channels()) {
    const std::string subject = subjectOf(*channel);
    // A delayed connection has both of its ends in this process: report it once.
    if (!found.empty() && found.back().subject == subject) continue;
    switch (channel->status.load(std::memory_order_acquire)) {
      case ChannelStatus::Lost:
        found.push_back({subject, lossTextOf(whyLost, channel->name()), true, true});
        if (const auto why = whyNotBack.find(channel->name()); why != whyNotBack.end()) {
          found.back().more = "cannot be made anew: " + why->second;
        }
        break;
      case ChannelStatus::Faulted:
        found.push_back({subject,
                         "brings nothing until its provider is restarted, which has faulted", true,
                         true});
        break;
      case ChannelStatus::Connected:
      case ChannelStatus::Lapsed:  // the client's process tells of it
      case ChannelStatus::Suspended:
      case ChannelStatus::Closed: break;
    }
  }
  return found;
}

}  // namespace suture
