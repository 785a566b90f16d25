#include "bench/figures/table.h"
#include "bench/network/bare_memory.h"
#include "bench/network/lanes.h"
#include "bench/network/rows.h"
#include "bench/network/sizes/block_client.h"
#include "bench/network/sizes/block_process.h"
#include "bench/placement.h"
#include "bench/table2/ping_pong.h"

namespace bench {
namespace {

constexpr std::size_t kPose = 120, kImage = std::size_t{1} << 20;

/// Returns many rounds for small blocks, few for large ones.
std::size_t roundsOf(std::size_t bytes, std::size_t all) {
  return bytes == kImage ? (all + 19) / 20 : all;
}

template <class Contract>
Statistics rounds(const NetworkOptions& options, const LaneOverSocket& row, const char* provided,
                  Blocks blocks) {
  const Pinned pinned(options.cpu);
  BlockClient<Contract> client(options.cpu, blocks, roundsOf(blocks.bytes, options.skipped()),
                               roundsOf(blocks.bytes, options.keptOfLane()));
  BlockProcess server(row.transport, options.cpu);
  server.manager().add("Client", client);
  auto samples = client.samples();
  server.manager().start();
  connectBy(row.lane, server.manager(), "Client/Server", provided);
  if (samples.wait_for(std::chrono::minutes(1)) != std::future_status::ready) {
    throw suture::SetupError("blocks going round", "they had not ended after a minute",
                             "Run it again");
  }
  return statisticsOf(inUnits(samples.get(), kMicrosecond));
}

bool isMemory(const LaneOverSocket& row) { return row.lane == suture::Lane::Shm; }

/// Returns how long an image takes over memory that two processes share, or over a bare socket.
Statistics floorOf(const NetworkOptions& options, const LaneOverSocket& row) {
  const std::size_t skip = roundsOf(kImage, options.skipped()),
                    kept = roundsOf(kImage, options.kept());
  return statisticsOf(inUnits(isMemory(row)
                                  ? bareMemoryRounds(kImage, options.cpu, skip, kept)
                                  : pingPong(row.transport, kImage, options.cpu, skip, kept),
                              kMicrosecond));
}

}  // namespace

std::string sizeRows(const NetworkOptions& options, Report& report) {
  const Unpreempted unpreempted;
  Table table(1);
  table.row(joined(joined({"us, there and back, one processor"}, statisticsTitles()), {"ratio"}));
  table.line();
  for (const LaneOverSocket& row : kLanesOverSockets) {
    if (!options.lane.empty() && options.lane != row.figure) continue;
    const std::string figure = std::string("sizes.") + row.figure;
    const Statistics small = rounds<SmallBlocks>(options, row, "server:Small/Blocks", {kPose});
    const Statistics roomy = rounds<LargeBlocks>(options, row, "server:Large/Blocks", {kPose});
    const Statistics large = rounds<LargeBlocks>(options, row, "server:Large/Blocks", {kImage});
    const Statistics loan =
        rounds<LargeBlocks>(options, row, "server:Loans/Blocks", {.bytes = kImage, .onLoan = true});
    const Statistics floor = floorOf(options, row);
    const double room = roomy.p50 / small.p50, ratio = large.p50 / floor.p50,
                 loanRatio = loan.p50 / floor.p50;
    report.add(figure + ".small", "us", small);
    report.add(figure + ".roomy", "us", roomy);
    report.add(figure + ".room", "x", room);
    report.add(figure + ".large", "us", large);
    report.add(figure + ".large.ratio", "x", ratio);
    report.add(figure + ".loan", "us", loan);
    report.add(figure + ".loan.ratio", "x", loanRatio);
    table.row(joined({std::string(row.title) + ": 120 bytes"}, cellsOf(small, 2)));
    table.row(joined(joined({"with room for 1 MiB"}, cellsOf(roomy, 2)), {number(room, 2)}));
    table.row(joined(joined({"1 MiB"}, cellsOf(large, 2)), {number(ratio, 2)}));
    table.row(joined(joined({"1 MiB, on loan"}, cellsOf(loan, 2)), {number(loanRatio, 2)}));
    table.row(
        joined({isMemory(row) ? "1 MiB, bare memory" : "1 MiB, bare socket"}, cellsOf(floor, 2)));
  }
  return table.toString();
}

}  // namespace bench
