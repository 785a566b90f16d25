#include "bench/table2/measure.h"

#include <suture/component/channel.h>
#include <suture/manager/global_manager.h>
#include <suture/manager/manager.h>
#include <suture/transport/rpc/control_thread.h>

#include <future>

#include "bench/placement.h"
#include "bench/table2/child_process.h"
#include "bench/table2/client.h"
#include "bench/table2/server.h"
#include "bench/table2/server_process.h"
#include "support/temporary_directory.h"

namespace bench {
namespace {

using suture::SetupError;

/// Waits for all samples: the periods that they take, and some.
void await(std::future<void> finished, const LoopSetup& setup) {
  const auto limit = 3 * setup.period * setup.total() + std::chrono::seconds(30);
  if (finished.wait_for(limit) == std::future_status::ready) return;
  throw SetupError(
      "going round a loop " + std::to_string(setup.total()) + " times",
      "it had not ended after " +
          std::to_string(std::chrono::duration_cast<std::chrono::seconds>(limit).count()) + " s",
      "Look for a message of either process above, or lower --samples");
}

std::vector<std::int64_t> kept(const std::vector<std::int64_t>& all, const LoopSetup& setup) {
  if (all.size() < setup.total()) {
    throw SetupError(std::to_string(setup.total()) + " samples of a loop",
                     std::to_string(all.size()) + " arrived", "Some were lost: run it again");
  }
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(setup.skip);
  return {begin, begin + static_cast<std::ptrdiff_t>(setup.samples)};
}

std::string managerAddress(const suture::TemporaryDirectory& folder, Transport transport) {
  return transport == Transport::Tcp ? "tcp://127.0.0.1:0" : "unix:" + folder.file("manager");
}

LoopResult resultOf(const Client& client, const std::vector<std::int64_t>& server,
                    const LoopSetup& setup, const suture::Channel& channel) {
  LoopResult result;
  const bool scs = setup.loop == Loop::Scs;
  result.elapsed = kept(scs ? server : client.elapsed(), setup);
  if (scs && setup.pace == Pace::EventDriven) result.client = kept(client.elapsed(), setup);
  result.failures = client.failures();
  result.lane = channel.lane;
  result.bytes = channel.bytesSent + channel.bytesReceived;
  return result;
}

void requireNetwork(const LoopResult& result) {
  if (result.lane == "rpc" && result.bytes > 0) return;
  throw SetupError("a connection over the lane rpc",
                   "lane " + result.lane + ", " + std::to_string(result.bytes) + " bytes",
                   "The figures would not be those of a network");
}

}  // namespace

LoopResult measureLocally(const LoopSetup& setup) {
  const Pinned pinned(setup.scheduling.processor);
  const auto server = makeServer(setup);
  const auto client = makeClient(setup);
  suture::Manager manager{"bench"};
  manager.add("Server", server->task());
  manager.add("Client", client->task());
  manager.connect("Client/Server", "Server/Loop");
  auto finished = client->finished();
  manager.start();
  await(std::move(finished), setup);
  const auto channel = manager.channels().at(0);
  manager.stop();
  return resultOf(*client, server->elapsed(), setup, *channel);
}

LoopResult measureAcross(const LoopSetup& setup, Transport transport) {
  const Pinned pinned(setup.scheduling.processor);
  const suture::TemporaryDirectory folder;
  suture::rpc::ControlThread control;
  const suture::GlobalManager names(control, managerAddress(folder, transport));
  ChildProcess serverProcess(serverProcessArguments(setup, names.address()));

  const auto client = makeClient(setup);
  suture::Manager manager{"client", names.address()};
  manager.add("Client", client->task());
  auto finished = client->finished();
  manager.start();
  manager.connect("Client/Server", "server:Server/Loop", suture::Lane::Rpc);
  await(std::move(finished), setup);
  const auto channel = manager.channels().at(0);
  manager.stop();
  const auto server = resultIn<std::int64_t>(serverProcess.finish());
  LoopResult result = resultOf(*client, server, setup, *channel);
  requireNetwork(result);
  return result;
}

}  // namespace bench
