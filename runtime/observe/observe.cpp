#include <suture/component/task.h>
#include <suture/observe/observe.h>

#include <algorithm>

namespace suture {
namespace {

Distribution distribution(const rt::Histogram& histogram) {
  return {histogram.count(), histogram.quantile(0.5), histogram.quantile(0.99), histogram.max()};
}

std::uint64_t count(const std::atomic<std::uint64_t>& counter) {
  return counter.load(std::memory_order_relaxed);
}

// A lane's own end of a channel is woken by a doorbell that is no component's.
ConnectionEnd endOf(const Channel& channel, const std::vector<Component*>& components) {
  const auto isComponents = [&](const rt::Doorbell* bell) {
    return std::any_of(components.begin(), components.end(),
                       [&](Component* one) { return &one->doorbell() == bell; });
  };
  if (!isComponents(channel.ends.client)) return ConnectionEnd::Provider;
  return isComponents(channel.ends.provider) ? ConnectionEnd::Both : ConnectionEnd::Client;
}

// The two ends of a connection share its watch; the client's thread counts.
std::optional<ContractReport> contractOf(const Channel& channel, ConnectionEnd end) {
  if (channel.watch == nullptr || end == ConnectionEnd::Provider) return std::nullopt;
  return ContractReport{
      .staleReads = count(channel.watch->staleReads),
      .losses = count(channel.watch->losses),
      .awaitsOperator = channel.watch->awaitsOperator.load(std::memory_order_relaxed)};
}

// Where both ends see all counts, each reports what it would see on another lane, so that nothing
// is counted twice.
void leaveToOtherEnd(ConnectionReport& report) {
  if (report.end == ConnectionEnd::Client) {
    report.superseded = report.late = report.failed = report.refused = 0;
  } else {
    report.full = report.tooLarge = report.invalid = report.replaced = 0;
  }
}

ConnectionReport reportOf(const Channel& channel, ConnectionEnd end) {
  const rt::MailboxCounters& counters = channel.commands.counters;
  ConnectionReport report{.name = channel.name,
                          .lane = channel.lane,
                          .laneReason = channel.laneReason,
                          .clockShift = channel.clockShift,
                          .clockError = channel.clockError,
                          .end = end,
                          .status = channel.status.load(std::memory_order_acquire),
                          .whyLost = "",
                          .bytesSent = count(channel.bytesSent),
                          .bytesReceived = count(channel.bytesReceived),
                          .contract = contractOf(channel, end),
                          .sent = count(counters.sent),
                          .executed = count(counters.executed),
                          .full = count(counters.full),
                          .tooLarge = count(counters.tooLarge),
                          .invalid = count(counters.invalid),
                          .replaced = count(counters.replaced),
                          .superseded = count(counters.superseded),
                          .late = count(counters.late),
                          .failed = count(counters.failed),
                          .refused = count(counters.refused),
                          .eventsDelivered = channel.events.delivered(),
                          .eventsDropped = channel.events.dropped(),
                          .lost = count(channel.delivery.lost),
                          .duplicated = count(channel.delivery.duplicated),
                          .overtaken = count(channel.delivery.overtaken),
                          .readAge = distribution(channel.readAge),
                          .commandAge = distribution(channel.commandAge)};
  if (channel.foreign) leaveToOtherEnd(report);
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
  const ComponentState state = task.state();
  return {.name = task.name(),
          .state = state,
          .fault = state == ComponentState::Faulted ? task.fault() : "",
          .faults = task.faults(),
          .cycles = count(statistics.cycles),
          .skipped = count(statistics.skipped),
          .lateness = distribution(statistics.lateness),
          .computeTime = distribution(statistics.computeTime),
          .window = reportOf(statistics.windows.last())};
}

DeviceReport reportOf(const Component& device) {
  const ComponentState state = device.state();
  return {.name = device.name(),
          .state = state,
          .fault = state == ComponentState::Faulted ? device.fault() : "",
          .faults = device.faults()};
}

}  // namespace

Report observe(const Manager& manager, Time began) {
  Report report{manager.process(), now() - began, {}, {}, {}};
  const std::vector<Component*> components = manager.directory().components();
  report.refusals = manager.refusals();
  const auto whyLost = manager.whyLost();
  for (const auto& channel : manager.channels()) {
    ConnectionReport& one =
        report.connections.emplace_back(reportOf(*channel, endOf(*channel, components)));
    const auto why = whyLost.find(channel->name);
    if (one.end != ConnectionEnd::Provider && why != whyLost.end()) one.whyLost = why->second;
  }
  for (const Component* component : components) {
    if (component->ownsThread()) {
      report.tasks.push_back(reportOf(static_cast<const Task&>(*component)));
    } else {
      report.devices.push_back(reportOf(*component));
    }
  }
  return report;
}

}  // namespace suture
