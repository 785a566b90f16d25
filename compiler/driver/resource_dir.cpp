#include "compiler/driver/resource_dir.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace suture::compiler::driver {

std::string resourceDirectory(const std::string& asked) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::vector<fs::path> candidates;
  if (!asked.empty()) {
    candidates = {asked};
  } else {
    const fs::path executable = fs::read_symlink("/proc/self/exe", ignored);
    candidates = {executable.parent_path() / "../lib/suture/clang", SUTUREC_RESOURCE_DIR};
  }
  std::string tried;
  for (const fs::path& candidate : candidates) {
    if (fs::exists(candidate / "include/stddef.h", ignored)) return candidate.string();
    tried += "\n  " + candidate.string();
  }
  throw std::runtime_error("clang's own headers (include/stddef.h) are in none of these folders:" +
                           tried + "\ninstall libclang-common-19-dev, or pass --resource-dir");
}

}  // namespace suture::compiler::driver
