#include "tables/screen.h"

#include <fmt/format.h>
#include <suture/observe/merge.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "tables/component_table.h"
#include "tables/connection_table.h"
#include "tables/paper_table.h"
#include "tables/units.h"
#include "timing/seconds.h"

namespace demo {
namespace {

using suture::ConnectionReport;
using suture::Duration;

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

Screen::Screen() : colours_(isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr) {}

std::string Screen::bold(const std::string& text) const {
  return colours_ ? "\x1b[1m" + text + "\x1b[0m" : text;
}

std::string Screen::verdictMark(bool passed) const {
  const char* word = passed ? "ok    " : "FAILED";
  if (!colours_) return word;
  return fmt::format("\x1b[{}m{}\x1b[0m", passed ? "32" : "1;31", word);
}

void Screen::begin(const Options& options, const Plan& plan, const Network& network) {
  fmt::print("{}  {}{}, {}, lane {}, {:g} Hz, {:g} s\n\n", bold("Teleoperation " + plan.name()),
             counted(plan.deployment().processes().size(), "process"),
             plan.needsManager() ? " and a global manager" : "",
             counted(plan.deployment().connections().size(), "connection"), options.lane,
             options.rate, options.seconds);
  if (const std::string title = plan.deployment().title(); !title.empty())
    fmt::print("  {}\n", title);
  if (plan.needsManager()) fmt::print("  processes talk over {}\n", network.description());
  for (const Following& following : plan.followings()) {
    fmt::print("  {} drives {}\n", following.master, following.slave);
  }
  if (const auto& knot = plan.knot()) {
    fmt::print("  two masters place a knot at [{:g}, {:g}, {:g}] mm by what cameras see\n",
               1e3 * knot->target.x(), 1e3 * knot->target.y(), 1e3 * knot->target.z());
  }
  const std::string& slow = plan.whyNotRealTime();
  if (plan.permit() > Duration{0}) {
    fmt::print("  drives need a permit that is at most {:.0f} ms old{}\n",
               1e3 * robots::inSeconds(plan.permit()), slow.empty() ? "" : ", for " + slow);
  } else if (!slow.empty()) {
    fmt::print("  no task has a real-time priority, for {}\n", slow);
  }
  if (const auto& stop = plan.stop()) {
    fmt::print("  the emergency stop is pressed after {:g} s and released {:g} s later\n",
               robots::inSeconds(stop->at), robots::inSeconds(stop->length));
  }
  fmt::print("\n{}\n",
             bold("  time   cycles  commands  replaced  dropped  late  command age   read age   "
                  "jitter  skipped     error"));
  fmt::print("{:>59}{:>12}{:>11}{:>19}\n", "p99 so far", "p99 so far", "p99 so far", "p99");
  std::fflush(stdout);
}

Screen::Totals Screen::totalsOf(const std::vector<suture::Report>& reports) {
  Totals totals;
  for (const ConnectionReport& one : suture::mergeConnections(reports)) {
    totals.executed += one.executed;
    totals.replaced += one.replaced;
    totals.dropped += one.dropped();
    totals.late += one.late;
    totals.commandAge = std::max(totals.commandAge, one.commandAge.p99);
    totals.readAge = std::max(totals.readAge, one.readAge.p99);
  }
  for (const suture::Report& report : reports) {
    for (const suture::TaskReport& task : report.tasks) {
      totals.cycles += task.cycles;
      totals.skipped += task.skipped;
      totals.jitter = std::max(totals.jitter, task.lateness.p99);
    }
  }
  return totals;
}

void Screen::progress(Duration ran, const std::vector<suture::Report>& reports,
                      std::optional<double> error) {
  const Totals before = std::exchange(shown_, totalsOf(reports));
  const Totals& now = shown_;
  if (ran == Duration{0}) return;
  fmt::print("{:>5.1f} s {:>7} {:>9} {:>9} {:>8} {:>5} {:>9} ms {:>7} ms {:>5} us {:>8} {:>9}\n",
             std::chrono::duration<double>(ran).count(), now.cycles - before.cycles,
             now.executed - before.executed, now.replaced - before.replaced,
             now.dropped - before.dropped, now.late - before.late, milliseconds(now.commandAge),
             milliseconds(now.readAge), microseconds(now.jitter), now.skipped - before.skipped,
             error ? fmt::format("{:.3f} mm", 1e3 * *error) : "-");
  std::fflush(stdout);
}

void Screen::printTable(const Table& table) const {
  const std::vector<std::string> lines = table.lines();
  if (lines.size() == 1) return;  // only the titles
  for (std::size_t i = 0; i < lines.size(); ++i) {
    fmt::print("{}\n", i == 0 ? bold(lines[i]) : lines[i]);
  }
  fmt::print("\n");
}

// This is printed below the table of slaves.
constexpr const char* kWhatErrorsAre =
    "Errors are against the goals that a slave has got, however old. At equal time, on average, it "
    "is\n"
    "compared with its master of that very moment: what travels is late, and off by speed x "
    "latency.";

void Screen::printSlaves(const std::vector<ArmFigures>& arms) const {
  Table table({"slave", "follows", "error p50 mm", "p99 mm", "max mm", "p99 deg", "travel mm",
               "at equal time mm", "speed x latency mm"});
  for (const ArmFigures& arm : arms) {
    if (!arm.following) continue;
    const robots::Judgement& following = *arm.following;
    table.add({arm.name, arm.master, fmt::format("{:.3f}", 1e3 * following.position.p50),
               fmt::format("{:.3f}", 1e3 * following.position.p99),
               fmt::format("{:.3f}", 1e3 * following.position.max),
               fmt::format("{:.3f}", kDegrees * following.orientation.p99),
               fmt::format("{:.1f}", 1e3 * following.travel),
               fmt::format("{:.3f}", 1e3 * following.equal_time.mean),
               fmt::format("{:.3f}", 1e3 * following.speed_times_latency)});
  }
  printTable(table);
  if (table.lines().size() == 1) return;
  fmt::print("{}\n\n", kWhatErrorsAre);
}

void Screen::printChecks(const std::vector<Check>& checks) const {
  for (const Check& check : checks) fmt::print("{}  {}\n", verdictMark(check.passed), check.text);
}

void Screen::end(const Plan& plan, const CrewResult& result, const Verdict& verdict) {
  fmt::print("\n");
  if (result.interrupted) {
    fmt::print("Interrupted after {:.1f} s; every process has been ended.\n\n",
               std::chrono::duration<double>(result.ran).count());
  }
  printTable(connectionTable(plan.deployment(), verdict.connections));
  fmt::print("{}\n\n", lostCommands(verdict.connections));
  printTable(componentTable(plan, result.reports));
  fmt::print("{}\n\n", processorTime(result.reports));
  const PaperTable paper(plan, verdict.connections);
  printTable(paper.table());
  for (const std::string& note : paper.notes()) fmt::print("{}\n", note);
  fmt::print("\n");
  printSlaves(verdict.arms);
  printChecks(verdict.checks);
  // The first failure is a check's text already.
  for (std::size_t i = 1; i < result.failures.size(); ++i) {
    fmt::print("        {}\n", result.failures[i]);
  }
  // A process that was cut off may have been frozen, and has missed cycles by that.
  if (verdict.passed() || result.outage) return;
  const std::string missed = whatTheyMissed(result.reports);
  if (!missed.empty()) fmt::print("{}\n", missed);
}

}  // namespace demo
