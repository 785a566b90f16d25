#include "bench/table2/measure.h"

#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>

#include <future>
#include <optional>
#include <thread>

#include "bench/placement.h"
#include "bench/table2/processes/child_process.h"
#include "bench/table2/processes/client.h"
#include "bench/table2/processes/server.h"
#include "bench/table2/processes/server_process.h"
#include "support/cable.h"
#include "support/temporary_directory.h"

namespace bench {
namespace {

using suture::SetupError;

/// Waits for all samples, for three times the periods that they take and 30 s. Throws SetupError if
/// they do not come.
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

std::string managerAddress(const suture::TemporaryDirectory& folder, const Between& between) {
  if (between.namespaces) return std::string("tcp://") + suture::Cable::kHere + ":0?insecure";
  return between.transport == Transport::Tcp ? "tcp://127.0.0.1:0"
                                             : "unix:" + folder.file("manager");
}

LoopResult resultOf(const Client& client, const std::vector<std::int64_t>& server,
                    const LoopSetup& setup, const suture::Channel& channel) {
  LoopResult result;
  result.elapsed = kept(setup.loop == Loop::Csc ? client.elapsed() : server, setup);
  if (setup.loop == Loop::Scs && setup.pace == Pace::EventDriven)
    result.client = kept(client.elapsed(), setup);
  result.failures = client.failures();
  result.lane = channel.lane;
  result.bytes = channel.bytesSent + channel.bytesReceived;
  return result;
}

void requireLane(const std::string& lane, const LoopResult& result) {
  if (result.lane == lane && (result.bytes > 0 || lane == "shm")) return;
  throw SetupError("a connection over the lane " + lane,
                   "lane " + result.lane + ", " + std::to_string(result.bytes) + " bytes",
                   "The figures would not be those of a network");
}

/// Stretches the cable to `server` once that process has a network namespace of its own.
void stretch(const suture::Cable& cable, pid_t server) {
  const std::string ours = suture::Cable::namespaceOf("thread-self");
  const suture::Time limit = suture::now() + std::chrono::seconds(10);
  while (suture::Cable::namespaceOf(std::to_string(server)) == ours) {
    if (suture::now() > limit) {
      throw SetupError("a server in a network namespace of its own", "it had none after 10 s",
                       "Look for a message of it above");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  cable.stretchTo(server);
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

LoopResult measureAcross(const LoopSetup& setup, const Between& between) {
  const Pinned pinned(setup.scheduling.processor);
  std::optional<suture::Cable> cable;
  if (between.namespaces) cable.emplace();
  const suture::TemporaryDirectory folder;
  suture::loop::ControlThread control;
  const suture::GlobalManager names(control, managerAddress(folder, between));
  ChildProcess serverProcess(serverProcessArguments(setup, names.address(), between.namespaces));
  if (cable) stretch(*cable, serverProcess.pid());

  const auto client = makeClient(setup);
  suture::Manager manager{"client", names.address()};
  manager.add("Client", client->task());
  auto finished = client->finished();
  manager.start();
  manager.connect("Client/Server", "server:Server/Loop", {.lane = between.lane});
  await(std::move(finished), setup);
  const auto channel = manager.channels().at(0);
  manager.stop();
  const auto server = resultIn<std::int64_t>(serverProcess.finish());
  LoopResult result = resultOf(*client, server, setup, *channel);
  requireLane(toString(between.lane), result);
  return result;
}

}  // namespace bench
