#include "tables/component_table.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <thread>

#include "tables/units.h"
#include "timing/seconds.h"

namespace demo {
namespace {

using suture::Duration;
using suture::Report;
using suture::TaskReport;

std::string askedRate(const nlohmann::json& parameters) {
  const auto period = parameters.find("period");
  return period == parameters.end() ? "-" : fmt::format("{:.0f}", 1 / period->get<double>());
}

std::string hadRate(const TaskReport& task) {
  const Duration mean = task.window.period.mean;
  return mean == Duration{0} ? "-" : fmt::format("{:.1f}", 1 / robots::inSeconds(mean));
}

/// Returns the share of its periods that had a cycle; none before the first.
std::optional<double> shareHeld(const TaskReport& task) {
  const auto cycles = static_cast<double>(task.cycles);
  const auto periods = cycles + static_cast<double>(task.skipped);
  if (periods == 0) return std::nullopt;
  return cycles / periods;
}

std::string held(const TaskReport& task) {
  const auto share = shareHeld(task);
  return share ? fmt::format("{:.2f}", 1e2 * *share) : "-";
}

/// A task that has a smaller share of its cycles makes a run fail that a quiet machine passes.
constexpr double kQuietShare = 0.95;

std::string share(const std::optional<Duration>& used, Duration age) {
  if (!used || age == Duration{0}) return "-";
  return fmt::format("{:.1f}", 1e2 * robots::inSeconds(*used) / robots::inSeconds(age));
}

}  // namespace

Table componentTable(const Plan& plan, const std::vector<Report>& reports) {
  Table table({"component", "process", "asked Hz", "had Hz", "held %", "cycles", "skipped",
               "jitter p99 us", "cycle p99 us", "processor %"});
  for (const Report& report : reports) {
    for (const TaskReport& task : report.tasks) {
      const auto& entry = plan.component(report.process + ":" + task.name);
      table.add({task.name, report.process, askedRate(entry.parameters), hadRate(task), held(task),
                 fmt::format("{}", task.cycles), fmt::format("{}", task.skipped),
                 microseconds(task.lateness.p99), microseconds(task.computeTime.p99),
                 share(task.processorTime, report.age)});
    }
  }
  return table;
}

std::string whatTheyMissed(const std::vector<Report>& reports) {
  double least = 1;
  std::string worst;
  for (const Report& report : reports) {
    for (const TaskReport& task : report.tasks) {
      const double share = shareHeld(task).value_or(1);
      if (share >= least) continue;
      least = share;
      worst = report.process + ":" + task.name;
    }
  }
  if (least >= kQuietShare) return "";
  return fmt::format(
      "This machine was too busy: {} had {:.0f} % of its cycles. End what else runs, or add --rate "
      "200.",
      worst, 1e2 * least);
}

std::string processorTime(const std::vector<Report>& reports) {
  double all = 0, tasks = 0;  // processors
  for (const Report& report : reports) {
    const double age = robots::inSeconds(report.age);
    if (age == 0) continue;
    all += robots::inSeconds(report.processorTime) / age;
    for (const TaskReport& task : report.tasks) {
      tasks += robots::inSeconds(task.processorTime.value_or(Duration{0})) / age;
    }
  }
  return fmt::format(
      "All processes had {:.0f} % of one processor, of which there are {}: tasks {:.0f} %, "
      "connections and the start {:.0f} %.",
      1e2 * all, std::thread::hardware_concurrency(), 1e2 * tasks, 1e2 * (all - tasks));
}

}  // namespace demo
