#pragma once

#include <suture/base/errors.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

namespace suture {

/// A TemporaryDirectory is a directory that no other user can enter, removed at the end with what
/// is in it. Throws SetupError if there cannot be one.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "suture-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw SetupError("a folder " + name, std::strerror(errno),
                       "Set TMPDIR to a folder that can be written");
    }
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace suture
