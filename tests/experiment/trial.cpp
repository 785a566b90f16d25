#include "experiment/trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace experiment {
namespace {

using namespace std::chrono_literals;
using suture::Duration;

// Linux waits at least this much longer than a round trip before a stream repeats what was not
// acknowledged (RFC 6298 has 1 s; tcp_rto_min is 200 ms).
constexpr Duration kLeastTimeout = 200ms;
// RFC 5681: the third acknowledgement that repeats one before it makes the sender repeat.
constexpr int kRepeatedAcknowledgements = 3;

Duration part(Duration whole, double share) {
  return std::chrono::duration_cast<Duration>(share * std::chrono::duration<double>(whole));
}

std::vector<Trial> grid(const std::vector<Duration>& delays, const std::vector<Link>& links) {
  std::vector<Trial> trials;
  for (const Link& kind : links) {
    for (const bool fixtures : {true, false}) {
      for (const Inputs inputs : {Inputs::Two, Inputs::One}) {
        for (const Duration delay : delays) {
          trials.push_back({{delay, kind.jitter, kind.loss}, fixtures, inputs});
        }
      }
    }
  }
  return trials;
}

}  // namespace

Duration repetitionTime(const Link& link, const Traffic& traffic) {
  const Duration packets = traffic.period / traffic.sharing;
  return link.roundTrip + std::min(kRepeatedAcknowledgements * packets, kLeastTimeout);
}

suture::ConnectionDelay delayOf(const Link& link, const Traffic& traffic, std::uint64_t seed) {
  const Duration way = link.roundTrip / 2;
  return {.commands = way,
          .answers = way,
          .faults = {.seed = seed << 8 | traffic.stream,
                     .delay = 1 - std::pow(1 - link.loss, traffic.sharing),
                     .delayLength = repetitionTime(link, traffic),
                     .delayAgain = link.loss,
                     .jitter = part(way, link.jitter),
                     .ordered = true}};
}

std::vector<Trial> fullGrid() {
  std::vector<Duration> delays;
  for (Duration delay{0}; delay <= 500ms; delay += 50ms) delays.push_back(delay);
  std::vector<Link> links;
  for (const double jitter : {0.0, 0.1}) {
    for (const double loss : {0.0, 0.01, 0.05, 0.1}) links.push_back({{}, jitter, loss});
  }
  return grid(delays, links);
}

std::vector<Trial> quickGrid() {
  return grid({0ms, 100ms, 200ms, 300ms, 400ms, 500ms},
              {{}, {.jitter = 0.1}, {.loss = 0.01}, {.loss = 0.1}});
}

}  // namespace experiment
