#pragma once
// This reads the lines of a recording from its file, whatever they hold.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

namespace robots {

/// Writes a line that says how many records before it are missing in the file.
void writeLost(std::ostream& out, std::uint64_t count);

/// One thread. Reads the lines of JSON that a RecordingWriter writes, even while it does.
class RecordingLines {
 public:
  using Take = std::function<void(const nlohmann::json& line)>;

  explicit RecordingLines(std::filesystem::path file) : file_(std::move(file)) {}

  /// Calls `take` with each whole line that is new since the last call; with none before the file
  /// exists. Throws suture::SetupError that names the file and the line if `take` cannot read it.
  void next(const Take& take);
  /// Does the same for the rest, once nobody writes the file any more. Throws too if the file does
  /// not exist, or ends within a line.
  void rest(const Take& take);
  /// Returns how many records are missing in the file, as the lines that have been read say.
  std::uint64_t lost() const { return lost_; }

 private:
  void parse(const Take& take);

  std::filesystem::path file_;
  std::ifstream in_;
  std::string unfinished_;  // a line without its end
  std::size_t lines_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace robots
