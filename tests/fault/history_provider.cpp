// A provider that writes down what it executes: history_provider <manager address> <process name>
// <log> <its number>. The events that it emits are numbered. Ends on SIGTERM.

#include <suture/manager/manager.h>

#include <chrono>
#include <cstdlib>

#include "fault/history_arm.h"
#include "support/hosted_process.h"

int main(int, char** argv) {
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    reference::HistoryArm arm(argv[3], std::atof(argv[4]));
    suture::Manager manager(argv[2], argv[1], std::chrono::minutes(1));
    manager.add("PSM", arm);
    manager.start();
    process.awaitEnd();
    manager.stop();
  });
}
