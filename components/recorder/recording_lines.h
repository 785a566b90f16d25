#pragma once
// Takes the lines of a recording from its file, whatever they hold.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

namespace robots {

/// Reads the lines of JSON that a RecordingWriter writes, also while it does. One thread.
class RecordingLines {
 public:
  using Take = std::function<void(const nlohmann::json& line)>;

  explicit RecordingLines(std::filesystem::path file) : file_(std::move(file)) {}

  /// Gives `take` each whole line that is new since the last call; none before the file exists.
  /// Throws suture::SetupError that names the file and the line if it is not what `take` reads.
  void next(const Take& take);
  /// Takes what is left, once nobody writes any more. Also throws if the file was never there, or
  /// ends within a line.
  void rest(const Take& take);

 private:
  void parse(const Take& take);

  std::filesystem::path file_;
  std::ifstream in_;
  std::string unfinished_;  // a line without its end
  std::size_t lines_ = 0;
};

}  // namespace robots
