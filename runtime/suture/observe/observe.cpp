#include <suture/component/channel/counts/ledger.h>
#include <suture/component/task/task.h>
#include <suture/observe/observe.h>
#include <suture/rt/counter.h>
#include <suture/rt/processor_clock.h>

#include <algorithm>
#include <map>
#include <string>

namespace suture {
namespace {

Distribution distribution(const rt::Histogram& histogram) {
  return {histogram.count(), histogram.quantile(0.5), histogram.quantile(0.99), histogram.max()};
}

// The two ends of a connection share its watch; the client's thread counts.
std::optional<ContractReport> contractOf(const Channel& channel) {
  if (channel.terms.watch == nullptr || channel.ends.components == ConnectionEnd::Provider) {
    return std::nullopt;
  }
  return ContractReport{
      .staleReads = rt::count(channel.terms.watch->staleReads),
      .losses = rt::count(channel.terms.watch->losses),
      .awaitsOperator = channel.terms.watch->awaitsOperator.load(std::memory_order_relaxed)};
}

// A connection within a process has one channel for as long as it exists.
Sums sumsOf(const std::shared_ptr<Channel>& channel) {
  if (channel->terms.ledger != nullptr) return channel->terms.ledger->sums();
  Ledger ledger(channel->ends.components);
  ledger.begin(channel, 0);
  return ledger.sums();
}

void putSums(const Sums& sums, ConnectionReport& report) {
  static_cast<Tally&>(report) = sums.tally;
  report.heard = sums.heard;
  report.sent = sums.accepted;
  report.full = sums.turnedDown.full;
  report.tooLarge = sums.turnedDown.tooLarge;
  report.invalid = sums.turnedDown.invalid;
  report.lost = sums.lost;
  report.unknown = sums.unknown;
  report.underWay = sums.underWay;
  report.otherIncarnation = sums.otherProcess;
  report.eventsDelivered = sums.eventsDelivered;
}

ConnectionReport reportOf(const std::shared_ptr<Channel>& shared) {
  const Channel& channel = *shared;
  ConnectionReport report;
  report.name = channel.name();
  report.lane = channel.lane;
  report.laneReason = channel.terms.laneReason;
  report.clockShift = channel.clockShift();
  report.clockError = channel.clockError();
  report.end = channel.ends.components;
  report.status = channel.status.load(std::memory_order_acquire);
  report.bytesSent = rt::count(channel.bytesSent);
  report.bytesReceived = rt::count(channel.bytesReceived);
  report.contract = contractOf(channel);
  putSums(sumsOf(shared), report);
  report.lastInvalid = channel.lastInvalid.read().text();
  report.messagesLost = rt::count(channel.client.delivery.lost);
  report.messagesDuplicated = rt::count(channel.client.delivery.duplicated);
  report.messagesOvertaken = rt::count(channel.client.delivery.overtaken);
  if (channel.client.readAge != nullptr) report.readAge = distribution(*channel.client.readAge);
  if (channel.provider.commandAge != nullptr)
    report.commandAge = distribution(*channel.provider.commandAge);
  return report;
}

WindowReport reportOf(const TaskWindow& window) {
  return {.length = window.end - window.begin,
          .cycles = window.cycles,
          .skipped = window.skipped,
          .period = window.period,
          .compute = window.compute};
}

TaskReport reportOf(const Task& task) {
  const TaskStatistics& statistics = task.statistics();
  const std::optional<rt::Scheduling> scheduling = task.scheduling();
  const ComponentState state = task.state();
  return {.name = task.name(),
          .state = state,
          .fault = state == ComponentState::Faulted ? task.fault() : "",
          .faults = task.faults(),
          .scheduling = scheduling ? toString(*scheduling) : "",
          .cycles = rt::count(statistics.cycles),
          .skipped = rt::count(statistics.skipped),
          .lateness = distribution(statistics.lateness),
          .computeTime = distribution(statistics.computeTime),
          .processorTime = task.processorTime(),
          .window = reportOf(statistics.windows.last())};
}

DeviceReport reportOf(const Component& device) {
  const ComponentState state = device.state();
  return {.name = device.name(),
          .state = state,
          .fault = state == ComponentState::Faulted ? device.fault() : "",
          .faults = device.faults()};
}

std::string reasonOf(const Channel& channel, const std::map<std::string, std::string>& reasons) {
  const auto found = reasons.find(channel.name());
  return found == reasons.end() ? "" : found->second;
}

}  // namespace

Report observe(const Manager& manager, Time began) {
  Report report{manager.process(), now() - began, {}, {}, {}};
  const std::vector<Component*> components = manager.directory().components();
  report.incarnation = manager.incarnation();
  report.refusals = manager.refusals();
  const auto whyLost = manager.whyLost(), whyNotBack = manager.whyNotBack();
  for (const auto& channel : manager.channels()) {
    if (channel->terms.ledger != nullptr && !channel->terms.ledger->isLatest(*channel)) continue;
    ConnectionReport& one = report.connections.emplace_back(reportOf(channel));
    if (channel->terms.ledger == nullptr)
      one.otherIncarnation = report.incarnation;  // both are here
    if (one.end == ConnectionEnd::Provider) continue;
    one.whyLost = reasonOf(*channel, whyLost);
    one.whyNotBack = reasonOf(*channel, whyNotBack);
  }
  for (const Component* component : components) {
    if (component->ownsThread()) {
      report.tasks.push_back(reportOf(static_cast<const Task&>(*component)));
    } else {
      report.devices.push_back(reportOf(*component));
    }
  }
  report.processorTime = rt::processorTimeOfProcess();
  return report;
}

}  // namespace suture
