#include "picture/process_graph.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "run/connection_name.h"
#include "tables/units.h"

namespace demo {
namespace {

using Eigen::Vector2d;
using picture::Canvas;
using robots::Colour;

constexpr Colour kInk{0, 0, 0}, kBoxes{215, 225, 245}, kPaper{255, 255, 255}, kWires{120, 120, 120};
constexpr double kLine = 18;   // px, from line to line
constexpr double kTitle = 30;  // px, above the graph
// With more processes than this there is no room for what each link has carried.
constexpr std::size_t kMostWithFigures = 6;

using Ends = std::pair<std::size_t, std::size_t>;

std::size_t indexOf(const ProcessGraph& graph, const std::string& process) {
  const auto& all = graph.processes;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == process; });
  return static_cast<std::size_t>(found - all.begin());
}

void add(ProcessGraph::Link& link, const suture::ConnectionReport& report) {
  ++link.connections;
  link.lanes.insert(report.lane);
  if (report.readAge.count > 0) link.reads = std::max(link.reads, report.readAge.p99);
  if (report.commandAge.count > 0) link.commands = std::max(link.commands, report.commandAge.p99);
}

/// Returns the place of a process on an ellipse, of which the first is at the left.
Vector2d placeOf(std::size_t process, const ProcessGraph& graph, const Canvas& canvas, int top) {
  const auto count = static_cast<double>(graph.processes.size());
  const double angle = std::numbers::pi * (1 + 2 * static_cast<double>(process) / count);
  const Vector2d middle(canvas.width() / 2.0, top + (kTitle + kGraphHeight) / 2.0);
  const Vector2d reach(0.36 * canvas.width(), (kGraphHeight - kTitle) / 2.0 - 2 * kLine);
  return middle + reach.cwiseProduct(Vector2d(std::cos(angle), std::sin(angle)));
}

/// Writes lines centred about a place, on a field of that colour.
void label(Canvas& canvas, const Vector2d& middle, const std::vector<std::string>& lines,
           Colour colour) {
  int widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, Canvas::widthOf(line));
  const Vector2d half(widest / 2.0 + 6, kLine * static_cast<double>(lines.size()) / 2 + 3);
  canvas.fill(middle - half, middle + half, colour);
  Vector2d place = middle - half + Vector2d(6, kLine - 2);
  for (const std::string& line : lines) {
    canvas.text(place, line, kInk);
    place.y() += kLine;
  }
}

std::vector<std::string> figuresOf(const ProcessGraph::Link& link) {
  std::vector<std::string> lines{
      fmt::format("{}, {}", counted(link.connections, "connection"), fmt::join(link.lanes, ", "))};
  std::string ages;
  if (link.reads > suture::Duration{0}) ages = "reads " + milliseconds(link.reads) + " ms";
  if (link.commands > suture::Duration{0}) {
    ages += (ages.empty() ? "" : ", ") + ("commands " + milliseconds(link.commands) + " ms");
  }
  if (!ages.empty()) lines.push_back(ages);
  return lines;
}

}  // namespace

ProcessGraph processGraph(const Plan& plan, const std::vector<suture::ConnectionReport>& reports) {
  ProcessGraph graph;
  for (const suture::ProcessEntry& process : plan.deployment().processes()) {
    graph.processes.push_back({process.name, process.components.size()});
  }
  std::map<std::string, Ends> ends;
  for (const suture::ConnectionEntry& one : plan.deployment().connections()) {
    ends[nameOf(one)] =
        std::minmax({indexOf(graph, one.from.process), indexOf(graph, one.to.process)});
  }
  std::map<Ends, ProcessGraph::Link> links;
  for (const suture::ConnectionReport& report : reports) {
    const auto found = ends.find(report.name);
    if (found == ends.end() || found->second.first == found->second.second) continue;
    ProcessGraph::Link& link = links[found->second];
    std::tie(link.first, link.second) = found->second;
    add(link, report);
  }
  for (const auto& [between, link] : links) graph.links.push_back(link);
  return graph;
}

void drawGraph(Canvas& canvas, const ProcessGraph& graph, int top) {
  const bool hasFigures = graph.processes.size() <= kMostWithFigures;
  canvas.text({40, top + kTitle - 8.0},
              std::string("the processes and what lies between them") +
                  (hasFigures ? "; ages: the greatest p99 of each kind" : ""),
              kInk);
  const auto place = [&](std::size_t process) { return placeOf(process, graph, canvas, top); };
  for (const auto& link : graph.links) canvas.line(place(link.first), place(link.second), kWires);
  for (const auto& link : graph.links) {
    if (!hasFigures) break;
    label(canvas, (place(link.first) + place(link.second)) / 2, figuresOf(link), kPaper);
  }
  for (std::size_t i = 0; i < graph.processes.size(); ++i) {
    const auto& [name, components] = graph.processes[i];
    label(canvas, place(i), {name, counted(components, "component")}, kBoxes);
  }
}

}  // namespace demo
