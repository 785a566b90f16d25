// This is a process that provides PSM/Arm: arm_host <manager address> <process name> [<folder of
// keys>]. It ends on SIGTERM.

#include <suture/manager/manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/keys.h>

#include <memory>

#include "integration/network/arm.h"
#include "support/hosted_process.h"

int main(int count, char** argv) {
  return suture::statusOf([count, argv] {
    const suture::HostedProcess process;
    reference::HostedArm arm;
    suture::Security security;
    if (count > 3) security.keys = std::make_shared<const suture::tls::Keys>(argv[3], argv[2]);
    suture::Manager manager(argv[2], argv[1], security);
    manager.add("PSM", arm);
    manager.start();
    process.awaitEnd();
    manager.stop();
  });
}
