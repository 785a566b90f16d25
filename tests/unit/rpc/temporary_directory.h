#pragma once
// A directory of the test's own, removed with what is in it.

#include <cstdlib>
#include <filesystem>
#include <string>

namespace suture {

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    char name[] = "/tmp/suture-test-XXXXXX";
    path_ = mkdtemp(name);
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace suture
