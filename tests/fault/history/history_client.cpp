// This is a client that writes down what it sends, how that ends, and what it hears: history_client
// <manager address> <process name> <log> <its number> <robot> busy|idle|bursts <longest silence,
// ms> <lane>. It says "begun", then "ready" when it is connected to <robot>:PSM/Arm. An idle one
// only listens. It ends on SIGTERM.

#include <suture/manager/manager.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "fault/history/history_caller.h"
#include "fault/history/history_sums.h"
#include "support/hosted_process.h"

namespace {

using namespace std::chrono_literals;

/// Connects, as often as it is refused, unless it is to end.
void connect(const suture::HostedProcess& process, suture::Manager& manager, const std::string& arm,
             const suture::Lane& lane, suture::Duration silence) {
  while (!process.ended()) {
    try {
      manager.connect("Client/Arm", arm,
                      {.lane = lane, .patience = 60s, .contract = {.silence = silence}});
      return suture::say("ready");
    } catch (const suture::SetupError&) {
      std::this_thread::sleep_for(5ms);
    }
  }
}

/// Waits for the outcomes of commands that a connected provider has yet to tell.
void awaitOutcomes(const suture::Manager& manager) {
  const auto areKnown = [&manager] {
    const auto all = suture::sumsOf(manager);
    return std::all_of(all.begin(), all.end(),
                       [](const auto& one) { return one.second.underWay == 0; });
  };
  for (int i = 0; i < 400 && !areKnown(); ++i) std::this_thread::sleep_for(5ms);
}

}  // namespace

int main(int, char** argv) {
  const std::string_view mode = argv[6];
  return suture::statusOf([argv, mode] {
    const suture::HostedProcess process;
    suture::HistoryCaller client(argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("Client", client);
    manager.start();
    suture::say("begun");
    const auto silence = std::chrono::milliseconds(std::atoi(argv[7]));
    connect(process, manager, std::string(argv[5]) + ":PSM/Arm", {argv[8]}, silence);
    while (!process.ended()) {
      client.waitForEvents(suture::now() + 5ms);
      client.processEvents();
      if (mode == "idle") client.look();
      if (mode == "busy") client.ask();
      if (mode == "bursts") client.burst();
    }
    awaitOutcomes(manager);
    for (const auto& [name, sums] : suture::sumsOf(manager)) client.noteLedger(sums);
    manager.stop();
  });
}
