#pragma once
// These read and write files. No file is ever seen half-written, because each is written beside its
// place and then renamed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suture::compiler::driver {

/// Returns none if the file cannot be read.
std::optional<std::string> readText(const std::filesystem::path& path);

/// Lets files appear together: each is written beside its place, and takes it when all are written.
/// The destructor removes what was not placed.
class NewFiles {
 public:
  NewFiles() = default;
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles();

  /// Throws std::runtime_error naming the file that cannot be written.
  void add(const std::filesystem::path& path, const std::string& text);
  /// Does the same, unless the file has this text already: then it returns false and leaves the
  /// file, whose date would make a build do work for nothing.
  bool addIfChanged(const std::filesystem::path& path, const std::string& text);
  /// Throws std::runtime_error naming the file that cannot take its place.
  void place();

 private:
  struct File {
    std::filesystem::path temporary, path;
  };
  std::vector<File> files_;
};

/// Writes one file whatever it holds already, so that its date is new. Throws std::runtime_error if
/// it cannot.
void writeText(const std::filesystem::path& path, const std::string& text);

/// Returns a Make rule: `target` depends on the files.
std::string makeRule(const std::string& target, const std::vector<std::string>& files);

}  // namespace suture::compiler::driver
