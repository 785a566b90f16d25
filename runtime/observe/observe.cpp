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

ConnectionReport reportOf(const Channel& channel, ConnectionEnd end) {
  const rt::MailboxCounters& counters = channel.commands.counters;
  return {.name = channel.name,
          .lane = channel.lane,
          .end = end,
          .status = channel.status.load(std::memory_order_acquire),
          .bytesSent = count(channel.bytesSent),
          .bytesReceived = count(channel.bytesReceived),
          .sent = count(counters.sent),
          .executed = count(counters.executed),
          .full = count(counters.full),
          .tooLarge = count(counters.tooLarge),
          .replaced = count(counters.replaced),
          .superseded = count(counters.superseded),
          .late = count(counters.late),
          .failed = count(counters.failed),
          .refused = count(counters.refused),
          .eventsDelivered = channel.events.delivered(),
          .eventsDropped = channel.events.dropped(),
          .readAge = distribution(channel.readAge),
          .commandAge = distribution(channel.commandAge)};
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
          .cycles = count(statistics.cycles),
          .skipped = count(statistics.skipped),
          .lateness = distribution(statistics.lateness),
          .computeTime = distribution(statistics.computeTime),
          .window = reportOf(statistics.windows.last())};
}

}  // namespace

Report observe(const Manager& manager, Time began) {
  Report report{manager.process(), now() - began, {}, {}};
  const std::vector<Component*> components = manager.directory().components();
  for (const auto& channel : manager.channels()) {
    report.connections.push_back(reportOf(*channel, endOf(*channel, components)));
  }
  for (const Component* component : components) {
    if (const auto* task = dynamic_cast<const Task*>(component); task != nullptr) {
      report.tasks.push_back(reportOf(*task));
    }
  }
  return report;
}

}  // namespace suture
