// This is a process that provides PSM1/Arm, of a task that sleeps until it has work, and PSM2/Arm,
// of a periodic one: faulty_host <manager address> <process name> <file while which they hang>. It
// ends on SIGTERM.

#include <suture/manager/manager.h>

#include <chrono>

#include "fault/faulty_arm.h"
#include "support/hosted_process.h"

int main(int, char** argv) {
  using namespace std::chrono_literals;
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    reference::FaultyArm<suture::EventTask> sleeping(argv[3],
                                                     suture::EventOptions{.longestSleep = 1h});
    reference::FaultyArm<suture::PeriodicTask> periodic(argv[3],
                                                        suture::PeriodicOptions{.period = 5ms});
    suture::Manager manager(argv[2], argv[1]);
    manager.add("PSM1", sleeping);
    manager.add("PSM2", periodic);
    manager.start();
    process.awaitEnd();
    manager.stop();
  });
}
