// A process that provides PSM1/Arm, of a task that sleeps until it has work, and PSM2/Arm, of a
// periodic one: faulty_host <manager address> <process name> <file while which they hang>. Ends on
// SIGTERM.

#include <suture/base/errors.h>
#include <suture/manager/manager.h>

#include <csignal>
#include <cstdio>

#include "fault/faulty_arm.h"

int main(int, char** argv) {
  using namespace std::chrono_literals;
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    reference::FaultyArm<suture::EventTask> sleeping(argv[3],
                                                     suture::EventOptions{.longestSleep = 1h});
    reference::FaultyArm<suture::PeriodicTask> periodic(argv[3],
                                                        suture::PeriodicOptions{.period = 5ms});
    suture::Manager manager(argv[2], argv[1]);
    manager.add("PSM1", sleeping);
    manager.add("PSM2", periodic);
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
