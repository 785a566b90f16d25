#include "run/network.h"

#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <suture/base/errors.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <utility>

namespace demo {
namespace {

// No packet leaves the namespace, so the addresses must only differ from each other.
constexpr const char* kHere = "10.213.7.1";
// Without an address of its own the switch has the lowest of its cables', which changes while
// cables are laid. Who had found the switch before then sends to nobody, for five seconds.
constexpr const char* kSwitchAddress = "02:00:0a:d5:07:01";
constexpr std::size_t kFirstCable = 2;

/// Runs a command of the shell. std::system() would throw away an interrupt that has come and has
/// not been read yet.
bool succeeds(const std::string& command) {
  const std::string quiet = "{ " + command + "; } >/dev/null 2>&1";
  const std::array<const char*, 4> words{"sh", "-c", quiet.c_str(), nullptr};
  pid_t shell = 0;
  if (posix_spawn(&shell, "/bin/sh", nullptr, nullptr, const_cast<char**>(words.data()), environ) !=
      0) {
    return false;
  }
  int status = 0;
  pid_t ended;
  do ended = waitpid(shell, &status, 0);
  while (ended < 0 && errno == EINTR);
  return ended == shell && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Returns which of the commands fails first; "" if none does.
std::string firstFailure(std::initializer_list<std::string> commands) {
  for (const std::string& command : commands) {
    if (!succeeds(command)) return "the command '" + command + "' fails";
  }
  return "";
}

/// Moves this process to a network namespace with a switch. Returns "", or why that cannot be done.
std::string moveToNamespace() {
  if (geteuid() != 0) return "network namespaces need root";
  if (const auto missing = firstFailure({"ip -V", "bridge -V", "nsenter -V"}); !missing.empty())
    return missing;
  const int before = open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
  if (before < 0 || unshare(CLONE_NEWNET) != 0) {
    const std::string why = std::strerror(errno);
    if (before >= 0) close(before);
    return "the kernel refuses a network namespace: " + why;
  }
  // One cable is laid and removed to see if that works; connect() lays the others.
  const std::string failure =
      firstFailure({"ip link set lo up",
                    "ip link add switch address " + std::string(kSwitchAddress) + " type bridge",
                    "ip addr add " + std::string(kHere) + "/24 dev switch", "ip link set switch up",
                    "ip link add cable type veth peer name other", "ip link del cable"});
  if (!failure.empty()) setns(before, CLONE_NEWNET);
  close(before);
  return failure;
}

}  // namespace

Network::Network(std::string asked, std::string lane)
    : asked_(std::move(asked)), lane_(std::move(lane)) {
  if (lane_ != "shm" || asked_ == "auto" || asked_ == "unix") return;
  throw suture::SetupError("lane shm over --network " + asked_,
                           "shared memory is for processes that reach each other by a Unix socket",
                           "Leave --network out, or choose another lane");
}

void Network::open() {
  const bool isAuto = asked_ == "auto";
  kind_ = asked_ == "tls" ? Kind::Tls : asked_ == "tcp" ? Kind::Tcp : Kind::Unix;
  if (asked_ != "namespaces" && (!isAuto || lane_ == "shm")) return;
  whyNoNamespaces_ = moveToNamespace();
  kind_ = whyNoNamespaces_.empty() ? Kind::Namespaces : Kind::Tcp;
  if (isAuto || whyNoNamespaces_.empty()) return;
  throw suture::SetupError("running over --network namespaces", whyNoNamespaces_,
                           "Run it as root with iproute2 installed, or leave --network out");
}

std::string Network::name() const {
  switch (kind_) {
    case Kind::None: return "none";
    case Kind::Unix: return "unix";
    case Kind::Tcp: return "tcp";
    case Kind::Tls: return "tls";
    case Kind::Namespaces: return "namespaces";
  }
  return "";
}

std::string Network::description() const {
  const std::string why = whyNoNamespaces_.empty() ? "" : " (" + whyNoNamespaces_ + ")";
  switch (kind_) {
    case Kind::None: return "nothing";
    case Kind::Unix: return "Unix sockets of one machine";
    case Kind::Tcp: return "TCP on loopback" + why;
    case Kind::Tls: return "TLS on loopback";
    case Kind::Namespaces:
      return "TLS on Ethernet between network namespaces, one for each process";
  }
  return "";
}

std::string Network::managerAddress(const std::filesystem::path& folder) const {
  switch (kind_) {
    case Kind::None: return "";
    case Kind::Unix: return "unix:" + (folder / "manager.sock").string();
    case Kind::Tcp: return "tcp://127.0.0.1:0";
    case Kind::Tls: return "tls://127.0.0.1:0";
    case Kind::Namespaces: return std::string("tls://") + kHere + ":0";
  }
  return "";
}

void Network::connect(const std::string& process, pid_t child) {
  const std::string number = std::to_string(kFirstCable + cables_.size());
  const std::string pid = std::to_string(child), here = "cable" + number;
  cables_[process] = here;
  const std::string there =
      "ip addr add 10.213.7." + number + "/24 dev eth0 && ip link set eth0 up && ip link set lo up";
  if (succeeds("ip link add " + here + " type veth peer name eth0 netns " + pid +
               " && ip link set " + here + " master switch up && nsenter --target " + pid +
               " --net sh -c '" + there + "'")) {
    return;
  }
  throw suture::SetupError("laying a cable to process '" + process + "'",
                           "the command 'ip' has failed", "Try --network tcp");
}

// The switch passes nothing on to the cable or from it, which neither end is told. If a link is set
// down and up again, Linux takes up to a second to notice, so the process would be away for longer.
void Network::setCable(const std::string& process, bool plugged) const {
  const std::string state = plugged ? "forwarding" : "disabled";
  if (succeeds("bridge link set dev " + cables_.at(process) + " state " + state)) return;
  throw suture::SetupError("pulling the cable of process '" + process + "'",
                           "the command 'bridge' has failed", "Try --network tcp");
}

}  // namespace demo
