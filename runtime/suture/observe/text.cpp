#include <suture/observe/text.h>

#include <array>
#include <cstdio>
#include <vector>

namespace suture {
namespace {

const char* nameOf(ConnectionEnd end) {
  switch (end) {
    case ConnectionEnd::Client: return "its client's end";
    case ConnectionEnd::Provider: return "its provider's end";
    case ConnectionEnd::Both: return "both ends";
  }
  return "";
}

std::string decimal(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string microseconds(Duration duration) {
  return decimal(std::chrono::duration<double, std::micro>(duration).count(), 1) + " us";
}

std::string milliseconds(Duration duration) {
  return decimal(std::chrono::duration<double, std::milli>(duration).count(), 1) + " ms";
}

std::string counted(const char* what, std::uint64_t count) {
  return std::string(what) + " " + std::to_string(count);
}

std::string distributed(const char* what, const Distribution& values) {
  if (values.count == 0) return "";
  return std::string(", ") + what + " p50 " + microseconds(values.p50) + ", p99 " +
         microseconds(values.p99) + ", max " + microseconds(values.max);
}

/// Returns "  PSM: running, faults 1", and why it does not run.
template <class Reported>
std::string lifeOf(const Reported& one) {
  return "  " + one.name + ": " + toString(one.state) +
         (one.fault.empty() ? "" : " (" + one.fault + ")") + ", " + counted("faults", one.faults);
}

std::string line(const TaskReport& task) {
  const bool special = !task.scheduling.empty() && task.scheduling != "default";
  return lifeOf(task) + (special ? ", " + task.scheduling : "") + ", " +
         counted("cycles", task.cycles) + ", " + counted("skipped", task.skipped) +
         distributed("lateness", task.lateness) + distributed("compute time", task.computeTime) +
         (task.processorTime ? ", processor time " + milliseconds(*task.processorTime) : "") + "\n";
}

std::string keptContract(const ConnectionReport& one) {
  if (one.end == ConnectionEnd::Provider) return "stale reads, losses: see the client's end";
  if (!one.contract) return "no contract";
  return counted("stale reads", one.contract->staleReads) + ", " +
         counted("losses", one.contract->losses) +
         (one.contract->awaitsOperator ? ", awaits its operator" : "");
}

std::string lines(const ConnectionReport& one) {
  const bool client = one.end != ConnectionEnd::Provider;
  const bool provider = one.end != ConnectionEnd::Client;
  std::string text = "  " + one.name + ": " + one.lane + ", " + toString(one.status) + ", " +
                     nameOf(one.end) + "\n    ";
  text += counted("sent", one.sent) + (client ? ", " : " (by the lane), ");
  text += counted("executed", one.executed) + (provider ? ", " : " (as heard), ");
  text += counted("dropped", one.dropped()) + (client && provider ? ", " : " (at this end), ");
  text += counted("late", one.late) + ", ";
  text += keptContract(one);
  if (!one.lastInvalid.empty()) text += ", last invalid " + one.lastInvalid;
  if (one.failed > 0) text += ", " + counted("failed", one.failed);
  if (one.eventsDropped > 0) text += ", " + counted("events dropped", one.eventsDropped);
  if (one.lost > 0) text += ", " + counted("lost", one.lost);
  if (one.unknown > 0) text += ", " + counted("unknown", one.unknown);
  if (one.underWay > 0) text += ", " + counted("under way", one.underWay);
  if (one.messagesLost > 0) text += ", " + counted("messages lost", one.messagesLost);
  if (one.messagesDuplicated > 0) text += ", " + counted("duplicated", one.messagesDuplicated);
  if (one.messagesOvertaken > 0) text += ", " + counted("overtaken", one.messagesOvertaken);
  if (one.clockError > Duration{0}) {
    text += "\n    other clock: shifted by " + microseconds(one.clockShift) + ", known to " +
            microseconds(one.clockError);
  }
  if (!one.laneReason.empty()) text += "\n    no faster lane: " + one.laneReason;
  if (!one.whyLost.empty()) text += ", last loss: " + one.whyLost;
  if (!one.whyNotBack.empty()) text += ", not back: " + one.whyNotBack;
  return text + distributed("age of reads", one.readAge) +
         distributed("age of commands", one.commandAge) + "\n";
}

template <class Reported, class Describe>
std::string section(const char* title, const std::vector<Reported>& all, const Describe& describe) {
  std::string text = all.empty() ? "" : std::string(title) + "\n";
  for (const Reported& one : all) text += describe(one);
  return text;
}

}  // namespace

std::string toText(const Report& report) {
  const double seconds = std::chrono::duration<double>(report.age).count();
  const net::Refusals::Summary& refusals = report.refusals;
  const std::string refused = refusals.count == 0
                                  ? ""
                                  : "refused to peers: " + std::to_string(refusals.count) +
                                        ", the latest to " + refusals.latest + "\n";
  return "process " + report.process + " after " + decimal(seconds, 1) + " s" +
         (report.processorTime > Duration{0}
              ? ", processor time " + milliseconds(report.processorTime)
              : "") +
         "\n" + refused +
         section("tasks", report.tasks, [](const TaskReport& one) { return line(one); }) +
         section("devices", report.devices,
                 [](const DeviceReport& one) { return lifeOf(one) + "\n"; }) +
         section("connections", report.connections,
                 [](const ConnectionReport& one) { return lines(one); });
}

}  // namespace suture
