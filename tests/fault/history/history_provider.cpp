// This is a provider that writes down what it executes: history_provider <manager address> <process
// name> <log> <its number> [<folder>]. The events that it emits are numbered. With a folder it also
// has a component that fails all the time, and a black box there for it, and prints what the box
// tells. It ends on SIGTERM.

#include <suture/manager/manager.h>
#include <suture/record/black_box.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fault/history/history_arm.h"
#include "fault/history/history_sums.h"
#include "fault/shaky_task.h"
#include "support/hosted_process.h"

namespace {

/// Returns the number of the client "client7:Client/Arm" of a connection; 0 if it is another's.
std::uint32_t clientIn(const std::string& connection) {
  constexpr std::string_view kProcess = "client";
  if (!connection.starts_with(kProcess)) return 0;
  return static_cast<std::uint32_t>(std::atoi(connection.c_str() + kProcess.size()));
}

}  // namespace

int main(int, char** argv) {
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    reference::HistoryArm arm(argv[3], static_cast<std::uint32_t>(std::atoi(argv[4])));
    arm.whenItRuns = [] { suture::say(reference::kTellsThatItRuns); };
    suture::ShakyTask shaky;
    suture::Manager manager(argv[2], argv[1], std::chrono::minutes(1));
    manager.add("PSM", arm);
    std::optional<suture::BlackBox> box;
    if (argv[5] != nullptr) {
      manager.add("Shaky", shaky);
      box.emplace(std::vector<suture::Component*>{&shaky},
                  suture::BlackBoxOptions{
                      .folder = argv[5], .rows = 256, .tell = [](const std::string& text) {
                        suture::say(text.c_str());
                      }});
    }
    manager.start();
    process.awaitEnd();
    arm.stop();
    for (const auto& [name, sums] : suture::sumsOf(manager)) {
      if (const std::uint32_t client = clientIn(name); client != 0) arm.noteLedger(client, sums);
    }
    manager.stop();
  });
}
