#include <suture/rt/doorbell.h>
#include <suture/rt/queue/spsc_ring.h>
#include <suture/rt/scheduling.h>
#include <suture/wiring/connect.h>

#include <cstring>
#include <thread>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/local/sample_client.h"
#include "bench/local/sample_server.h"
#include "bench/placement.h"

namespace bench {
namespace {

using Samples = std::vector<std::int64_t>;
using robots::PoseSample;
using suture::now;

constexpr suture::Duration kLongestWait = std::chrono::seconds(1);
constexpr std::size_t kSkipped = 100;

Samples taskRounds(int cpu, std::size_t count) {
  SampleTask server(cpu);
  SampleClient client(cpu, kSkipped, count);
  auto samples = client.samples();
  suture::connectLocally(client.server, server.provided(), "bench");
  server.start();
  client.start();
  return samples.get();
}

/// A RingWay is one direction of the bare ping-pong.
struct RingWay {
  suture::rt::SpscRing ring{suture::rt::SpscRing::recordSize(sizeof(PoseSample)),
                            sizeof(PoseSample)};
  suture::rt::Doorbell bell;

  void send(const PoseSample& value) {
    std::memcpy(ring.claim(sizeof(value)), static_cast<const void*>(&value), sizeof(value));
    ring.commit();
    bell.ring();
  }
  void receive(PoseSample& value) {
    const std::byte* memory;
    while ((memory = ring.front()) == nullptr) bell.waitUntil(now() + kLongestWait);
    std::memcpy(static_cast<void*>(&value), memory, sizeof(value));
    ring.pop();
  }
};

Samples bareRounds(int cpu, std::size_t count) {
  RingWay there, back;
  const std::size_t total = kSkipped + count;
  std::thread echo([&] {
    suture::rt::configureThisThread("bare-echo", {.processor = cpu});
    PoseSample value;
    for (std::size_t i = 0; i < total; ++i) {
      there.receive(value);
      back.send(value);
    }
  });
  Samples elapsed;
  std::thread client([&] {
    suture::rt::configureThisThread("bare-client", {.processor = cpu});
    PoseSample value = poseSample();
    for (std::size_t i = 0; i < total; ++i) {
      value.stamp = now();
      there.send(value);
      back.receive(value);
      elapsed.push_back((now() - value.stamp).count());
    }
  });
  client.join();
  echo.join();
  elapsed.erase(elapsed.begin(), elapsed.begin() + kSkipped);
  return elapsed;
}

void append(Samples& to, const Samples& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

std::string cscRows(const LocalOptions& options, Report& report) {
  constexpr int kTurns = 20;
  Samples tasks, bare;
  for (int turn = 0; turn < kTurns; ++turn) {
    append(bare, bareRounds(options.cpu, options.count(5000)));
    append(tasks, taskRounds(options.cpu, options.count(5000)));
  }
  const Statistics csc = statisticsOf(inUnits(tasks, kMicrosecond));
  const Statistics floor = statisticsOf(inUnits(bare, kMicrosecond));
  const double ratio = csc.p50 / floor.p50;
  report.add("csc", "us", csc);
  report.add("bare", "us", floor);
  report.add("csc.ratio", "x", ratio);
  Table table(1);
  table.row(joined({"us, both ends on one processor"}, statisticsTitles()));
  table.line();
  table.row(joined({"CSC of two event-driven tasks"}, cellsOf(csc, 2)));
  table.row(joined({"two rings, two futexes, nothing else"}, cellsOf(floor, 2)));
  table.row({"ratio of the medians", "", "", "", number(ratio, 2)});
  return table.toString();
}

}  // namespace bench
