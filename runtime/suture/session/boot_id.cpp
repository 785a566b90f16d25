#include <suture/session/boot_id.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace suture {

// Includes the time namespace, because processes of one machine that differ in it may have other
// clocks.
std::string bootId() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  std::error_code none;
  return id + " " + std::filesystem::read_symlink("/proc/self/ns/time", none).string();
}

}  // namespace suture
