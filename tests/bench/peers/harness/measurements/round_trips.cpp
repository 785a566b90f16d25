#include <vector>

#include "harness/clock.h"
#include "harness/figures.h"
#include "harness/measurements/contact.h"
#include "harness/measurements/measurements.h"
#include "harness/usage.h"

namespace peers {
namespace {

constexpr long kWarmUp = 2000;

void print(std::vector<double> times, const Usage& used, bool same) {
  const auto count = static_cast<double>(times.size());
  Figures()
      .add("same", same ? 1 : 0)
      .add(statisticsOf(std::move(times)))
      .add("client_cpu", 1e-3 * static_cast<double>(used.here) / count)
      .add("server_cpu", 1e-3 * static_cast<double>(used.there) / count)
      .add("switches", static_cast<double>(used.switches) / count)
      .add("loopback_bytes", static_cast<double>(used.loopbackBytes) / count)
      .add("loopback_packets", static_cast<double>(used.loopbackPackets) / count)
      .print();
}

}  // namespace

void measureRoundTrips(Peer& peer, const Options& options, ControlBlock& control) {
  const auto client = peer.client(options, 0);
  Pose sent, back;
  fill(sent, 0);
  reachByEcho(*client, sent);
  bool same = true;
  const auto timed = [&](long number) {
    fill(sent, static_cast<std::uint64_t>(number));
    const std::int64_t begin = now();
    client->echo(sent, back);
    const std::int64_t end = now();
    same = same && sent == back;
    return 1e-3 * static_cast<double>(end - begin);
  };
  for (long i = 0; i < kWarmUp; ++i) timed(i);
  std::vector<double> times(static_cast<std::size_t>(options.count));
  const Usage before = Usage::with(control.process[0]);
  for (long i = 0; i < options.count; ++i) times[static_cast<std::size_t>(i)] = timed(i);
  print(std::move(times), Usage::with(control.process[0]) - before, same);
}

}  // namespace peers
