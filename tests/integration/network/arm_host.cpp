// A process that provides PSM/Arm: arm_host <manager address> <process name> [<folder of keys>].
// Ends on SIGTERM.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>
#include <suture/manager/security.h>
#include <suture/transport/tls/keys.h>

#include <csignal>
#include <cstdio>
#include <memory>

#include "integration/network/arm.h"

int main(int count, char** argv) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    reference::HostedArm arm;
    suture::Security security;
    if (count > 3) security.keys = std::make_shared<const suture::tls::Keys>(argv[3], argv[2]);
    suture::Manager manager(argv[2], argv[1], security);
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
