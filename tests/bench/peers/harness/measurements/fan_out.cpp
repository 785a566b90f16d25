#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "harness/clock.h"
#include "harness/fail.h"
#include "harness/figures.h"
#include "harness/measurements/contact.h"
#include "harness/measurements/drain.h"
#include "harness/measurements/measurements.h"
#include "harness/usage.h"

namespace peers {
namespace {

using namespace std::chrono_literals;

constexpr long kWarmUp = 200;
constexpr std::int64_t kNever = -1;

Clients clientsOf(Peer& peer, const Options& options) {
  Clients clients;
  const int needed = peer.publishes() ? 1 : options.servers;
  for (int server = 0; server < needed; ++server) {
    clients.push_back(peer.client(options, server));
  }
  return clients;
}

/// Publishes those poses at 1 kHz, each stamped with its time. None is flushed: it has to leave by
/// itself.
void publish(const Clients& clients, long begin, long end) {
  auto next = std::chrono::steady_clock::now();
  Pose pose;
  for (long i = begin; i < end; ++i) {
    next += 1ms;
    std::this_thread::sleep_until(next);
    fill(pose, static_cast<std::uint64_t>(i));
    pose.timestamp = static_cast<double>(now());
    for (const auto& client : clients) client->send(pose);
  }
}

struct Deliveries {
  std::vector<double> last;  ///< us until the last server had each pose
  long lost = 0;
};

Deliveries deliveriesOf(const ControlBlock& control, const Options& options) {
  Deliveries deliveries;
  for (long i = kWarmUp; i < kWarmUp + options.count; ++i) {
    std::int64_t last = kNever;
    for (int server = 0; server < options.servers; ++server) {
      const std::int64_t latency = control.latency[server][i];
      if (latency == kNever) ++deliveries.lost;
      last = std::max(last, latency);
    }
    if (last != kNever) deliveries.last.push_back(1e-3 * static_cast<double>(last));
  }
  return deliveries;
}

}  // namespace

void measureFanOut(Peer& peer, const Options& options, ControlBlock& control) {
  if (kWarmUp + options.count > kMostPublished) fail("so many poses cannot be told apart");
  const Clients clients = clientsOf(peer, options);
  reach(clients, control, options.servers);
  std::vector<std::uint64_t> awaited;
  for (int server = 0; server < options.servers; ++server) {
    awaited.push_back(control.received[server].count +
                      static_cast<std::uint64_t>(kWarmUp + options.count));
  }
  for (auto& server : control.latency) std::fill(std::begin(server), std::end(server), kNever);
  control.stamped = true;
  publish(clients, 0, kWarmUp);
  const std::int64_t before = processorTime(getpid());
  publish(clients, kWarmUp, kWarmUp + options.count);
  const auto used = static_cast<double>(processorTime(getpid()) - before);
  for (int server = 0; server < options.servers; ++server) {
    drain(control.received[server], awaited[static_cast<std::size_t>(server)]);
  }
  Deliveries deliveries = deliveriesOf(control, options);
  Figures()
      .add("lost", static_cast<double>(deliveries.lost))
      .add(statisticsOf(std::move(deliveries.last)))
      .add("client_cpu", 1e-3 * used / static_cast<double>(options.count))
      .print();
}

}  // namespace peers
