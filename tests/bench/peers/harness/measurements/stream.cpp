#include <unistd.h>

#include "harness/clock.h"
#include "harness/fail.h"
#include "harness/figures.h"
#include "harness/measurements/contact.h"
#include "harness/measurements/drain.h"
#include "harness/measurements/measurements.h"
#include "harness/usage.h"

namespace peers {
namespace {

constexpr std::uint64_t kWarmUp = 2000;

/// Sends until one of the limits, from the pose of that number on, and returns how many.
std::uint64_t send(Client& client, std::uint64_t first, std::uint64_t most, double seconds) {
  const std::int64_t end = now() + static_cast<std::int64_t>(seconds * kSecond);
  Pose pose;
  std::uint64_t sent = 0;
  for (; sent < most; ++sent) {
    if (sent % 64 == 0 && now() > end) break;
    fill(pose, first + sent);
    client.send(pose);
  }
  client.flush();
  return sent;
}

}  // namespace

void measureStream(Peer& peer, const Options& options, ControlBlock& control) {
  Clients clients;
  clients.push_back(peer.client(options, 0));
  Client& client = *clients.front();
  const Received& received = control.received[0];
  const std::uint64_t first = reach(clients, control, 1), reached = received.count;
  const std::uint64_t warmUp = send(client, first, kWarmUp, options.seconds);
  if (!drain(received, reached + warmUp)) fail("poses of the warm-up did not arrive");

  const std::uint64_t before = received.count, disorder = received.disorder;
  const std::int64_t here = processorTime(getpid()), there = processorTime(control.process[0]);
  const std::int64_t begin = now();
  const std::uint64_t sent =
      send(client, first + warmUp, static_cast<std::uint64_t>(options.count), options.seconds);
  drain(received, before + sent);
  const auto count = static_cast<double>(received.count - before);
  Figures()
      .add("received", count)
      .add("lost", static_cast<double>(sent) - count)
      .add("disorder", static_cast<double>(received.disorder - disorder))
      .add("per_second", count * kSecond / static_cast<double>(received.last - begin))
      .add("client_cpu", 1e-3 * static_cast<double>(processorTime(getpid()) - here) / count)
      .add("server_cpu",
           1e-3 * static_cast<double>(processorTime(control.process[0]) - there) / count)
      .print();
}

}  // namespace peers
