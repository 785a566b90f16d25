#include <suture/session/boot_id.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace suture {

// Tells the time namespace too, by which processes of one machine may have other clocks.
std::string bootId() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  std::error_code none;
  return id + " " + std::filesystem::read_symlink("/proc/self/ns/time", none).string();
}

}  // namespace suture
