#include "experiment/agreement.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "timing/seconds.h"

namespace experiment {
namespace {

using namespace std::chrono_literals;

double share(double real, double stepped) { return real / stepped - 1; }

std::string timeOf(const Result& result) {
  return result.time ? fmt::format("{:8.3f}", *result.time) : "   never";
}

std::string line(const char* name, const Result& result) {
  return fmt::format("  {:8}{} s{:9.3f} mm{:9.3f} mm{:9.3f} mm{:7.1f} %  {}\n", name,
                     timeOf(result), 1e3 * result.error, 1e3 * result.tracking50,
                     1e3 * result.tracking99, 1e2 * result.guided, toString(result.outcome));
}

}  // namespace

std::vector<Trial> realTimePoints() {
  return {{.link = {.roundTrip = 0ms}},
          {.link = {.roundTrip = 100ms}},
          {.link = {.roundTrip = 200ms}},
          {.link = {.roundTrip = 100ms, .jitter = 0.1}},
          {.link = {.roundTrip = 100ms, .loss = 0.01}},
          {.link = {.roundTrip = 200ms, .loss = 0.01}}};
}

double differenceOfTime(const Point& point) {
  const auto& real = point.real.result.time;
  const auto& stepped = point.stepped.time;
  if (real && stepped) return share(*real, *stepped);
  return real || stepped ? std::numeric_limits<double>::infinity() : 0;
}

double differenceOfTracking(const Point& point) {
  return share(point.real.result.tracking50, point.stepped.tracking50);
}

bool agrees(const Point& point) {
  return point.real.result.outcome == point.stepped.outcome &&
         std::abs(differenceOfTime(point)) <= kAgrees &&
         std::abs(differenceOfTracking(point)) <= kAgrees;
}

std::string describe(const Point& point) {
  const Link& link = point.trial.link;
  return fmt::format(
             "round trip {:.0f} ms, jitter {:.0f} %, loss {:.0f} %, fixtures {}: time {:+.1f} %, "
             "tracking {:+.1f} %{}; {} packets, {} lost\n",
             1e3 * robots::inSeconds(link.roundTrip), 1e2 * link.jitter, 1e2 * link.loss,
             point.trial.fixtures ? "on" : "off", 1e2 * differenceOfTime(point),
             1e2 * differenceOfTracking(point), agrees(point) ? "" : ", which is not within 10 %",
             point.real.packets, point.real.lost) +
         line("real", point.real.result) + line("stepped", point.stepped);
}

}  // namespace experiment
