#include "experiment/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "timing/seconds.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;

constexpr double kNever = std::numeric_limits<double>::infinity();

bool allPlaced(const std::vector<Result>& results) {
  return std::all_of(results.begin(), results.end(),
                     [](const Result& one) { return one.outcome == Outcome::Placed; });
}

std::string line(const char* name, const Result& result) {
  const std::string time = result.time ? fmt::format("{:8.3f}", *result.time) : "   never";
  return fmt::format("  {:8}{} s{:9.3f} mm{:9.3f} mm{:9.3f} mm{:7.1f} %  {}\n", name, time,
                     1e3 * result.error, 1e3 * result.tracking50, 1e3 * result.tracking99,
                     1e2 * result.guided, toString(result.outcome));
}

}  // namespace

std::vector<Trial> realTimePoints() {
  return {{.link = {.roundTrip = 0ms}, .fixtures = false},
          {.link = {.roundTrip = 100ms}, .fixtures = false},
          {.link = {.roundTrip = 100ms}},
          {.link = {.roundTrip = 200ms}},
          {.link = {.roundTrip = 100ms, .jitter = 0.1}},
          {.link = {.roundTrip = 100ms, .loss = 0.01}}};
}

double figureOf(const Trial& trial, const std::vector<Result>& results) {
  double sum = 0;
  for (const Result& one : results) {
    sum += trial.fixtures ? one.time.value_or(kNever) : one.tracking50;
  }
  return sum / static_cast<double>(results.size());
}

double difference(const Point& point) {
  const double real = figureOf(point.trial, point.real);
  const double stepped = figureOf(point.trial, point.stepped);
  return std::isfinite(real) && std::isfinite(stepped) ? real / stepped - 1 : kNever;
}

bool agrees(const Point& point) {
  return std::abs(difference(point)) <= kAgrees && allPlaced(point.real) &&
         allPlaced(point.stepped);
}

std::string describe(const Point& point) {
  const Link& link = point.trial.link;
  const bool fixtures = point.trial.fixtures;
  const auto figure = [&](const std::vector<Result>& results) {
    const double value = figureOf(point.trial, results);
    return fixtures ? fmt::format("{:.3f} s", value) : fmt::format("{:.4f} mm", 1e3 * value);
  };
  std::string text = fmt::format(
      "Round trip {:.0f} ms, jitter {:.0f} %, loss {:.0f} %, fixtures {}: {} {} in real time, {} "
      "stepped, {:+.1f} %{} ({} of {} packets were lost)\n",
      1e3 * robots::inSeconds(link.roundTrip), 1e2 * link.jitter, 1e2 * link.loss,
      fixtures ? "on" : "off", fixtures ? "placed after" : "tracked within", figure(point.real),
      figure(point.stepped), 1e2 * difference(point),
      agrees(point) ? "" : ", which is not within 10 %", point.lost, point.packets);
  for (const Result& one : point.real) text += line("real", one);
  for (const Result& one : point.stepped) text += line("stepped", one);
  return text;
}

}  // namespace experiment
