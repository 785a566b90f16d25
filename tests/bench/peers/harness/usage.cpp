#include "harness/usage.h"

#include <time.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace peers {
namespace {

std::int64_t contextSwitches(pid_t process) {
  std::int64_t switches = 0;
  std::error_code gone;
  const std::string threads = "/proc/" + std::to_string(process) + "/task";
  for (const auto& thread : std::filesystem::directory_iterator(threads, gone)) {
    std::ifstream status(thread.path() / "status");
    for (std::string line; std::getline(status, line);) {
      const std::size_t colon = line.find("ctxt_switches:");
      if (colon != std::string::npos) switches += std::stoll(line.substr(line.find(':') + 1));
    }
  }
  return switches;
}

void countLoopback(Usage& usage) {
  std::ifstream interfaces("/proc/net/dev");
  for (std::string name; interfaces >> name;) {
    if (name == "lo:") interfaces >> usage.loopbackBytes >> usage.loopbackPackets;
  }
}

}  // namespace

std::int64_t processorTime(pid_t process) {
  clockid_t clock;
  timespec time;
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec;
}

Usage Usage::with(pid_t other) {
  Usage usage;
  usage.switches = contextSwitches(getpid()) + contextSwitches(other);
  countLoopback(usage);
  usage.here = processorTime(getpid());
  usage.there = processorTime(other);
  return usage;
}

Usage Usage::operator-(const Usage& earlier) const {
  return {here - earlier.here, there - earlier.there, switches - earlier.switches,
          loopbackBytes - earlier.loopbackBytes, loopbackPackets - earlier.loopbackPackets};
}

}  // namespace peers
