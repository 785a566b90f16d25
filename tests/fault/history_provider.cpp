// A provider that writes down what it executes: history_provider <manager address> <process name>
// <log> <its number>. The events that it emits are numbered. Ends on SIGTERM.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "fault/history_arm.h"

using namespace std::chrono_literals;

int main(int, char** argv) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    reference::HistoryArm arm(argv[3], std::atof(argv[4]));
    suture::Manager manager(argv[2], argv[1], 60s);
    manager.add("PSM", arm);
    manager.start();
    std::puts("ready");
    std::fflush(stdout);
    int received = 0;
    sigwait(&signals, &received);
    manager.stop();
  } catch (const suture::SetupError& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
  return 0;
}
