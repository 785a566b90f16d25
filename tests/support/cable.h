#pragma once
// These are two network namespaces and the cable between them: two machines as far as the network
// goes. They need root, and iproute2.

#include <sched.h>
#include <sys/types.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace suture {

/// A Cable is that of the calling thread's namespace; threads and processes that it starts inherit
/// it. All functions throw std::runtime_error where the kernel or iproute2 refuses.
class Cable {
 public:
  static constexpr const char* kHere = "10.213.7.1";
  static constexpr const char* kThere = "10.213.7.2";

  /// Moves the calling thread to a namespace of its own.
  Cable() {
    leave();
    run("ip link set lo up && ip link add here type veth peer name there && ip addr add " +
        std::string(kHere) + "/24 dev here && ip link set here up");
  }
  static void leave() {
    if (unshare(CLONE_NEWNET) != 0) throw std::runtime_error("no network namespace of its own");
  }
  /// Gives the far end to a process that has left.
  void stretchTo(pid_t process) const { run("ip link set there netns " + std::to_string(process)); }
  /// Makes the far end ready; the other process calls it, once the cable has come.
  static void plugIn() { run(pluggingIn()); }
  static std::string pluggingIn() {
    return "ip addr add " + std::string(kThere) + "/24 dev there && ip link set there up";
  }

  /// Names the network namespace of "thread-self", or of a process by its id.
  static std::string namespaceOf(const std::string& process) {
    return std::filesystem::read_symlink("/proc/" + process + "/ns/net").string();
  }

  void pull() const { run("ip link set here down"); }
  void putBack() const { run("ip link set here up"); }

 private:
  static void run(const std::string& command) {
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  }
};

}  // namespace suture
