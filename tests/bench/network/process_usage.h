#pragma once
// The kernel tells with these what a process has used and holds.

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace bench {

/// Counts how often a thread has gone to sleep until now: `task` is its folder under /proc.
inline double wakeUpsOf(const std::filesystem::path& task) {
  std::ifstream status(task / "status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("voluntary_ctxt_switches:")) return std::stod(line.substr(24));
  }
  return 0;
}

/// Returns the same of all threads of process `pid`.
inline double wakeUpsOf(pid_t pid) {
  double sum = 0;
  const std::filesystem::path tasks = "/proc/" + std::to_string(pid) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks)) sum += wakeUpsOf(task.path());
  return sum;
}

inline double descriptorsOf(pid_t pid) {
  const std::filesystem::directory_iterator all("/proc/" + std::to_string(pid) + "/fd");
  return static_cast<double>(std::distance(begin(all), end(all)));
}

}  // namespace bench
