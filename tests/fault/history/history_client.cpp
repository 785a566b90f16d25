// This is a client that writes down what it sends, how that ends, and what it hears: history_client
// <manager address> <process name> <log> <its number> <robot> <mode> <longest silence, ms> <lane>.
// It says "begun", then "ready" when it is connected to <robot>:PSM/Arm. It ends on SIGTERM. In the
// mode idle it only listens, busy it asks, bursts it sends bursts. In the modes operator and
// operator-reads its commands await an operator after a loss, for whom SIGUSR1 stands. The former
// sends bursts, and the latter reads before it asks, and what it reads may be stale.

#include <suture/manager/manager.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include "fault/history/history_caller.h"
#include "fault/history/history_sums.h"
#include "support/hosted_process.h"

namespace {

using namespace std::chrono_literals;

/// Make this before any thread, since threads inherit the mask. Hears what the test says as the
/// operator.
class Operator {
 public:
  Operator() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  /// Returns true if the operator has asked since the last time.
  bool resumes() const {
    const timespec none{};
    return sigtimedwait(&signals_, nullptr, &none) == SIGUSR1;
  }

 private:
  sigset_t signals_;
};

/// Returns the terms that the mode asks for.
suture::ConnectionContract contractOf(std::string_view mode, suture::Duration silence) {
  suture::ConnectionContract contract{.silence = silence};
  if (mode.starts_with("operator")) contract.resume = suture::Resume::Operator;
  if (mode == "operator-reads") contract.maxAge = 1s;
  return contract;
}

/// Connects, as often as it is refused, unless it is to end.
void connect(const suture::HostedProcess& process, suture::Manager& manager, const std::string& arm,
             const suture::Lane& lane, const suture::ConnectionContract& contract) {
  while (!process.ended()) {
    try {
      manager.connect("Client/Arm", arm, {.lane = lane, .patience = 60s, .contract = contract});
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
    const Operator person;
    suture::HistoryCaller client(argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("Client", client);
    manager.start();
    suture::say("begun");
    const auto silence = std::chrono::milliseconds(std::atoi(argv[7]));
    connect(process, manager, std::string(argv[5]) + ":PSM/Arm", {argv[8]},
            contractOf(mode, silence));
    while (!process.ended()) {
      client.waitForEvents(suture::now() + 5ms);
      client.processEvents();
      if (mode == "idle") client.look();
      if (person.resumes()) client.resume(manager, "Client/Arm");
      if (mode == "operator-reads") client.read();
      if (mode == "busy" || mode == "operator-reads") client.ask();
      if (mode == "bursts" || mode == "operator") client.burst();
    }
    awaitOutcomes(manager);
    for (const auto& [name, sums] : suture::sumsOf(manager)) client.noteLedger(sums);
    manager.stop();
  });
}
