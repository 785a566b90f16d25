// A process that provides PSM/Arm: arm_host <manager address> <process name>. Ends on SIGTERM.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>

#include <csignal>
#include <cstdio>

#include "integration/network/arm.h"

int main(int, char** argv) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    reference::HostedArm arm;
    suture::Manager manager(argv[2], argv[1]);
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
