#pragma once
// These tell what this process holds of the machine.

#include <suture/base/sanitizers.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace suture {

inline std::size_t entriesOf(const char* folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                std::filesystem::directory_iterator()));
}

inline std::size_t openDescriptors() { return entriesOf("/proc/self/fd"); }
inline std::size_t openOf(const char* kind) {
  std::size_t count = 0;
  for (const auto& one : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code closed;
    if (read_symlink(one.path(), closed).string().starts_with(kind)) ++count;
  }
  return count;
}
inline std::size_t openSockets() { return openOf("socket:"); }
/// Counts memory that another process may map.
inline std::size_t openMemory() { return openOf("/memfd:"); }
inline std::size_t threads() { return entriesOf("/proc/self/task"); }

inline std::size_t residentBytes() {
  std::size_t size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// This is false under a sanitizer, which keeps what has been freed.
#if defined(SUTURE_ADDRESS_SANITIZER) || defined(SUTURE_THREAD_SANITIZER)
constexpr bool kGivesMemoryBack = false;
#else
constexpr bool kGivesMemoryBack = true;
#endif

}  // namespace suture
