#include <suture/wiring/connect.h>

#include <thread>
#include <vector>

#include "bench/figures/table.h"
#include "bench/local/sample_device.h"
#include "bench/local/sample_server.h"
#include "bench/network/lanes.h"
#include "bench/network/processes/sample_process.h"
#include "bench/network/rows.h"
#include "bench/placement.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

void awaitValue(SampleDevice& client) {
  robots::PoseSample value;
  while (!client.server.value(value)) std::this_thread::yield();
}

/// ns a read.
double measureReads(SampleDevice& client) {
  robots::PoseSample value;
  const auto read = [&] {
    const auto answer = client.server.value(value);
    keep(answer);
    keep(value);
  };
  return timedLoops(1, 20'000, read).p50;
}

/// Holds a provider in this process, and its client.
struct Near {
  explicit Near(const NetworkOptions& options) : provider(options.otherCpu) {
    suture::connectLocally(client.server, provider.provided(), "bench");
    provider.start();
    awaitValue(client);
  }
  SampleTask provider;
  SampleDevice client;
};

/// Holds a provider in another process, and its client.
struct Far {
  explicit Far(const NetworkOptions& options) : provider(Transport::Unix, options.otherCpu) {
    provider.manager().add("Client", client);
    provider.manager().start();
    connectBy(suture::Lane::Shm, provider.manager(), "Client/Server", "server:Server/Samples");
    awaitValue(client);
  }
  SampleDevice client;  // outlives its manager
  SampleProcess provider;
};

}  // namespace

std::string mirrorRows(const NetworkOptions& options, Report& report) {
  const Pinned pinned(options.cpu);
  Near near(options);
  Far far(options);
  std::vector<double> locals, mirrors, ratios;
  for (std::size_t turn = 0; turn < options.readLoops(); ++turn) {
    locals.push_back(measureReads(near.client));
    mirrors.push_back(measureReads(far.client));
    ratios.push_back(mirrors.back() / locals.back());
  }
  const Statistics local = statisticsOf(locals), mirror = statisticsOf(mirrors),
                   ratio = statisticsOf(ratios);
  report.add("local_read", "ns", local);
  report.add("mirror_read", "ns", mirror);
  report.add("mirror_read.ratio", "x", ratio);
  Table table(1);
  table.row(joined({"ns, by turns"}, statisticsTitles()));
  table.line();
  table.row(joined({"read command, provider in this process"}, cellsOf(local, 1)));
  table.row(joined({"the same, provider in another one, shm"}, cellsOf(mirror, 1)));
  table.row(joined({"  ratio of each pair"}, cellsOf(ratio, 2)));
  return table.toString();
}

}  // namespace bench
