#include <suture/wiring/connect.h>

#include <thread>

#include "bench/local/sample_device.h"
#include "bench/local/sample_server.h"
#include "bench/network/rows.h"
#include "bench/network/sample_process.h"
#include "bench/placement.h"
#include "bench/table.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

Statistics measureReads(SampleDevice& client, const NetworkOptions& options) {
  robots::PoseSample value;
  while (!client.server.value(value)) std::this_thread::yield();
  return timedLoops(options.readLoops(), 100'000, [&] {
    const auto read = client.server.value(value);
    keep(read);
    keep(value);
  });
}

Statistics localReads(const NetworkOptions& options) {
  SampleTask server(options.otherCpu);
  SampleDevice client;
  suture::connectLocally(client.server, server.provided(), "bench");
  server.start();
  return measureReads(client, options);
}

Statistics mirrorReads(const NetworkOptions& options) {
  SampleDevice client;  // outlives its manager
  SampleProcess server(Transport::Unix, options.otherCpu);
  server.manager().add("Client", client);
  server.manager().start();
  server.manager().connect("Client/Server", "server:Server/Samples", suture::Lane::Shm);
  return measureReads(client, options);
}

}  // namespace

std::string mirrorRows(const NetworkOptions& options, Report& report) {
  const Pinned pinned(options.cpu);
  const Statistics local = localReads(options), mirror = mirrorReads(options);
  const double ratio = mirror.p50 / local.p50;
  report.add("local_read", "ns", local);
  report.add("mirror_read", "ns", mirror);
  report.add("mirror_read.ratio", "x", ratio);
  Table table(1);
  table.row(joined({"ns"}, statisticsTitles()));
  table.line();
  table.row(joined({"read command, provider in this process"}, cellsOf(local, 1)));
  table.row(joined({"the same, provider in another one, shm"}, cellsOf(mirror, 1)));
  table.row({"ratio of the medians", "", "", "", number(ratio, 2)});
  return table.toString();
}

}  // namespace bench
