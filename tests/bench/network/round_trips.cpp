#include "bench/figures/table.h"
#include "bench/local/sample_client.h"
#include "bench/network/bare_memory.h"
#include "bench/network/lanes.h"
#include "bench/network/message_bytes.h"
#include "bench/network/processes/sample_process.h"
#include "bench/network/rows.h"
#include "bench/placement.h"
#include "bench/table2/ping_pong.h"

namespace bench {
namespace {

using Samples = std::vector<std::int64_t>;
using suture::Lane;
using suture::SetupError;

struct LaneRow {
  const char* title;
  const char* figure;
  Transport transport;
  Lane lane;
  const char* floor;  // the figure that it is a multiple of
};

const LaneRow kLaneRows[] = {
    {"shm", "shm", Transport::Unix, Lane::Shm, "raw.shm"},
    {"frame, Unix socket", "frame.unix", Transport::Unix, Lane::Frame, "raw.unix"},
    {"frame, different builds", "frame.encoded", Transport::Unix, kEncodedFrames, "raw.unix"},
    {"frame, TCP", "frame.tcp", Transport::Tcp, Lane::Frame, "raw.tcp"},
    {"frame, TLS", "frame.tls", Transport::Tls, Lane::Frame, "raw.tcp"},
    {"rpc, Unix socket", "rpc.unix", Transport::Unix, Lane::Rpc, "raw.unix"},
    {"rpc, TCP", "rpc.tcp", Transport::Tcp, Lane::Rpc, "raw.tcp"},
    {"rpc, TLS", "rpc.tls", Transport::Tls, Lane::Rpc, "raw.tcp"},
};

Samples taskRounds(const NetworkOptions& options, const LaneRow& row) {
  const Pinned pinned(options.cpu);
  SampleClient client(options.cpu, options.skipped(),
                      options.keptOfLane());  // outlives its manager
  SampleProcess server(row.transport, options.cpu);
  server.manager().add("Client", client);
  auto samples = client.samples();
  server.manager().start();
  connectBy(row.lane, server.manager(), "Client/Server", "server:Server/Samples");
  if (samples.wait_for(std::chrono::minutes(1)) != std::future_status::ready) {
    throw SetupError("going round a loop", "it had not ended after a minute", "Run it again");
  }
  return samples.get();
}

/// Returns the lanes to measure: all, or the one that a user names.
std::vector<LaneRow> wantedRows(const NetworkOptions& options) {
  std::vector<LaneRow> wanted;
  std::string known;
  for (const LaneRow& row : kLaneRows) {
    known += (known.empty() ? "" : ", ") + std::string(row.figure);
    if (options.lane.empty() || options.lane == row.figure) wanted.push_back(row);
  }
  if (wanted.empty()) {
    throw SetupError("the round trips of lane " + options.lane, "there is no such lane",
                     "Name one of " + known);
  }
  return wanted;
}

Statistics floorOf(const NetworkOptions& options, const std::string& figure) {
  const std::size_t skip = options.skipped(), kept = options.kept();
  const Samples samples =
      figure == "raw.shm" ? bareMemoryRounds(sizeof(robots::PoseSample), options.cpu, skip, kept)
                          : pingPong(figure == "raw.tcp" ? Transport::Tcp : Transport::Unix,
                                     kMessageBytes, options.cpu, skip, kept);
  return statisticsOf(inUnits(samples, kMicrosecond));
}

}  // namespace

std::string roundTripRows(const NetworkOptions& options, Report& report) {
  const Unpreempted unpreempted;
  Table table(1);
  table.row(joined(joined({"us, both ends on one processor"}, statisticsTitles()), {"ratio"}));
  table.line();
  for (const LaneRow& row : wantedRows(options)) {
    const Statistics floor = floorOf(options, row.floor);
    const Statistics tasks = statisticsOf(inUnits(taskRounds(options, row), kMicrosecond));
    const double ratio = tasks.p50 / floor.p50;
    report.add(row.floor, "us", floor);
    report.add(row.figure, "us", tasks);
    report.add(std::string(row.figure) + ".ratio", "x", ratio);
    table.row(joined({row.floor}, cellsOf(floor, 2)));
    table.row(joined(joined({row.title}, cellsOf(tasks, 2)), {number(ratio, 2)}));
  }
  const auto encoded = report.find("frame.encoded.p50"), equal = report.find("frame.unix.p50");
  if (encoded && equal) report.add("frame.encoded.builds", "x", encoded->value / equal->value);
  return table.toString();
}

}  // namespace bench
