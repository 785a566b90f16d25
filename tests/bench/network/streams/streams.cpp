#include <suture/base/errors.h>
#include <suture/component/channel/channel.h>

#include <string>
#include <utility>
#include <vector>

#include "bench/figures/table.h"
#include "bench/network/lanes.h"
#include "bench/network/message_bytes.h"
#include "bench/network/processes/sample_process.h"
#include "bench/network/rows.h"
#include "bench/network/streams/bare_stream.h"
#include "bench/network/streams/stream_client.h"
#include "bench/placement.h"
#include "support/eventually.h"

namespace bench {
namespace {

using namespace std::chrono_literals;

struct Stream {
  Statistics rates;  // M/s
  std::uint64_t lost;
};

/// Returns how many of `sent` commands have not been executed. It waits for those that have, since
/// the provider tells with a delay.
std::uint64_t lostOf(const suture::Channel& channel, std::uint64_t sent) {
  const auto executed = [&] {
    return channel.counts->heard(suture::ConnectionEnd::Client).executed;
  };
  return suture::eventually([&] { return executed() >= sent; }) ? 0 : sent - executed();
}

Stream streamOver(const NetworkOptions& options, const LaneOverSocket& row) {
  const Pinned pinned(options.cpu);
  StreamClient client(options.cpu, options.streamBlock(), options.streamBlocks());
  SampleProcess server(row.transport, options.otherCpu);
  server.manager().add("Client", client);
  auto rates = client.rates();
  server.manager().start();
  connectBy(row.lane, server.manager(), "Client/Server", "server:Server/Samples");
  if (rates.wait_for(1min) != std::future_status::ready) {
    throw suture::SetupError("a stream of poses", "it had not ended after a minute",
                             "Run it again");
  }
  const std::uint64_t lost = lostOf(*server.manager().channels().at(0), client.sent());
  return {statisticsOf(rates.get()), lost};
}

}  // namespace

std::string streamRows(const NetworkOptions& options, Report& report) {
  Table table(1);
  table.row(joined({"million poses a second, one way"}, statisticsTitles()));
  table.line();
  for (const Transport transport : {Transport::Unix, Transport::Tcp}) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < options.streamBlocks(); ++i) {
      rates.push_back(bareStream(transport, kMessageBytes, options.cpu, options.otherCpu,
                                 options.streamBlock()));
    }
    const Statistics bare = statisticsOf(std::move(rates));
    const bool isTcp = transport == Transport::Tcp;
    report.add(isTcp ? "streams.raw.tcp" : "streams.raw.unix", "M/s", bare);
    table.row(joined({isTcp ? "bare socket, TCP" : "bare socket, Unix"}, cellsOf(bare, 3)));
  }
  for (const LaneOverSocket& row : kLanesOverSockets) {
    const Stream stream = streamOver(options, row);
    const std::string figure = std::string("streams.") + row.figure;
    report.add(figure, "M/s", stream.rates);
    report.add(figure + ".lost", "poses", static_cast<double>(stream.lost));
    table.row(joined({row.title}, cellsOf(stream.rates, 3)));
  }
  return table.toString();
}

}  // namespace bench
