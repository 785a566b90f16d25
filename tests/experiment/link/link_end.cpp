#include "experiment/link/link_end.h"

#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <future>

namespace experiment {
namespace {

constexpr const char* kDevice = "link";

[[noreturn]] void refuse(const std::string& found) {
  throw suture::SetupError("making a network namespace with a TUN device", found,
                           "Run it as root (CAP_SYS_ADMIN, CAP_NET_ADMIN), with /dev/net/tun "
                           "(modprobe tun) and iproute2");
}

[[noreturn]] void refuseFor(const std::string& what) { refuse(what + ": " + std::strerror(errno)); }

int opened(const char* file, int flags) {
  const int descriptor = open(file, flags | O_CLOEXEC);
  if (descriptor < 0) refuseFor(std::string("opening ") + file);
  return descriptor;
}

/// Opens a device of the calling thread's namespace.
int openDevice() {
  const int device = opened("/dev/net/tun", O_RDWR | O_NONBLOCK);
  ifreq request{};
  std::strcpy(request.ifr_name, kDevice);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  if (ioctl(device, TUNSETIFF, &request) == 0) return device;
  const int error = errno;
  close(device);
  errno = error;
  refuseFor("making a TUN device");
}

void configure(const std::string& address, const std::string& peer) {
  const std::string device = std::string(" dev ") + kDevice;
  // IPv6 would send packets of its own accord, and each takes its turn of the losses. Cubic is
  // Linux's default; BBR, that of some machines, sends next to nothing for 0.3 s each 10 s.
  const std::string command =
      "for all in /proc/sys/net/ipv6/conf/*/disable_ipv6; do [ ! -e $all ] || echo 1 >$all; done; "
      "ip link set lo up && ip addr add " +
      address + " peer " + peer + device + " && ip link set up" + device + " && ip route replace " +
      peer + device + " src " + address + " congctl cubic";
  if (std::system(command.c_str()) != 0) refuse("the command '" + command + "' fails");
}

}  // namespace

// This runs in a thread that ends, so that its caller stays where it is.
LinkEnd::LinkEnd(const std::string& address, const std::string& peer) {
  const auto make = [&] {
    if (unshare(CLONE_NEWNET) != 0) refuseFor("leaving for a network namespace");
    namespace_ = opened("/proc/thread-self/ns/net", O_RDONLY);
    packets_ = openDevice();
    configure(address, peer);
  };
  try {
    std::async(std::launch::async, make).get();
  } catch (...) {
    closeAll();
    throw;
  }
}

LinkEnd::~LinkEnd() { closeAll(); }

void LinkEnd::closeAll() const {
  for (const int one : {namespace_, packets_}) {
    if (one >= 0) close(one);
  }
}

void LinkEnd::enter() const {
  if (setns(namespace_, CLONE_NEWNET) != 0) refuseFor("entering a network namespace");
}

}  // namespace experiment
