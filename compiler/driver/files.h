#pragma once
// Writing without disturbing: no half-written file, and none touched whose text stays.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suture::compiler::driver {

/// None if the file cannot be read.
std::optional<std::string> readText(const std::filesystem::path& path);

/// Files that appear together: each is written beside its place, and takes it when all are written.
/// What was not placed is removed at the end.
class NewFiles {
 public:
  NewFiles() = default;
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles();

  /// Throws std::runtime_error naming the file that cannot be written.
  void add(const std::filesystem::path& path, const std::string& text);
  /// False if the file has this text already and is left alone.
  bool addIfChanged(const std::filesystem::path& path, const std::string& text);
  /// Throws std::runtime_error naming the file that cannot take its place.
  void place();

 private:
  struct File {
    std::filesystem::path temporary, path;
  };
  std::vector<File> files_;
};

/// One file, whatever it holds already: its date is of now.
void writeText(const std::filesystem::path& path, const std::string& text);

/// A Make rule: `target` depends on the files.
std::string makeRule(const std::string& target, const std::vector<std::string>& files);

}  // namespace suture::compiler::driver
