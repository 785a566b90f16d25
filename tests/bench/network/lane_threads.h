#pragma once
// These are the threads of this process that carry frames.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace bench {

/// Such a thread has this name: runtime/suture/lane/frame/lane_thread.cpp says it.
inline constexpr const char* kLaneThread = "suture-lane";

/// Returns how many there are now.
inline std::uint64_t laneThreads() {
  std::uint64_t found = 0;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    if (name == kLaneThread) ++found;
  }
  return found;
}

}  // namespace bench
